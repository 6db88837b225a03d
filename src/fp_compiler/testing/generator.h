#pragma once
#include <array>
#include <optional>
#include <vector>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/testing/interval.h"
#include "fp_compiler/testing/random.h"

namespace arbiter::fp::testing {

/// What the generators of every language share: temporaries whose written components and ranges
/// are known, operands, and arithmetic that keeps inside each function's domain.
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
  /// A constant, env, local or state row.
  virtual Picked parameter();
  virtual ir::StateRef stateRef();
  /// Anything that may be read, with a swizzle and a sign.
  Picked operand(bool scalar, bool extended);
  void swizzle(Picked &picked, std::uint8_t readable, bool scalar, bool extended);
  /// A scalar operand inside [lo, hi], clamped and scaled into it if it is not there already.
  Picked scalarWithin(float lo, float hi);
  std::vector<Picked> operandsOf(ir::Opcode op);
  void arithmetic(ir::Opcode op);
  ir::Destination destination(ir::Opcode op);
  /// What becomes of a result that is larger than a tame program's may be.
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
  /// Brings components of a temporary into [lo, hi], which languages without _SAT need.
  void clamp(const ir::Destination &dst, float lo, float hi);
};

} // namespace arbiter::fp::testing
