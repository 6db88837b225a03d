#pragma once
#include <array>
#include <optional>
#include <vector>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/testing/interval.h"
#include "fp_compiler/testing/random.h"

namespace arbiter::fp::testing {

/// The common part of the program generators. It tracks the temporaries' written components and
/// value ranges, makes operands, and keeps arithmetic inside each function's domain.
class Generator {
public:
  virtual ~Generator() = default;

protected:
  using Intervals = std::array<Interval, 4>;
  struct Picked {
    ir::Source source;
    Intervals ranges; ///< after swizzle and sign
  };

  Generator(ir::Language language, std::uint64_t seed, const RandomOptions &options)
      : m_random(seed), m_options(options), m_builder(language) {}

  ir::Target newTemporary();
  virtual Picked attribute() = 0;
  /// Returns a constant, env, local or state row.
  virtual Picked parameter();
  virtual ir::StateRef stateRef();
  /// Returns any readable operand, with a swizzle and a sign.
  Picked operand(bool scalar, bool extended);
  void swizzle(Picked &picked, std::uint8_t readable, bool scalar, bool extended);
  /// Returns a scalar operand inside [lo, hi]. Clamps and scales it if needed.
  Picked scalarWithin(float lo, float hi);
  std::vector<Picked> operandsOf(ir::Opcode op);
  void arithmetic(ir::Opcode op);
  ir::Destination destination(ir::Opcode op);
  /// True if a large result of a tame program is saturated.
  virtual bool saturates() const { return true; }
  void record(const ir::Destination &dst, const Intervals &result);
  void emit(ir::Opcode op, const ir::Destination &dst, const std::vector<Picked> &picked);

  Random m_random;
  RandomOptions m_options;
  ir::Builder m_builder;
  std::vector<ir::Target> m_temporaries;
  std::vector<Intervals> m_ranges;
  std::vector<std::uint8_t> m_written;

private:
  float literal();
  std::optional<std::size_t> readableTemporary();
  /// Clamps components of a temporary to [lo, hi], for languages without _SAT.
  void clamp(const ir::Destination &dst, float lo, float hi);
};

} // namespace arbiter::fp::testing
