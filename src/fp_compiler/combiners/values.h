#pragma once
#include <optional>
#include <vector>

#include "fp_compiler/combiners/state.h"
#include "fp_compiler/ir/builder.h"

namespace arbiter::fp::combiners {

/// What a portion computes: a vector in x, y and z, or a scalar in w.
enum class Half : std::uint8_t { Rgb, Alpha };

/// A computed value of one half, with what is known of its range: clamps that cannot do anything
/// are not emitted.
struct Value {
  static constexpr float kAny = 3e38f;

  ir::Source source;
  float low = -kAny;
  float high = kAny;
  std::optional<float> literal; ///< of every component

  [[nodiscard]] bool is(float number) const { return literal && *literal == number; }
};

/// The arithmetic of register combiners as instructions. Every result is a new temporary, so that
/// values stay what they were; what is known while compiling is not computed.
class Values {
public:
  explicit Values(ir::Builder &builder) : m_builder(builder) {}

  [[nodiscard]] Value literal(float number);
  [[nodiscard]] Value atLeast(Half half, const Value &value, float bound);
  [[nodiscard]] Value atMost(Half half, const Value &value, float bound);
  [[nodiscard]] Value negated(const Value &value);
  /// value * scale + bias
  [[nodiscard]] Value scaled(Half half, const Value &value, float scale, float bias);
  [[nodiscard]] Value product(Half half, const Value &a, const Value &b);
  /// a * b + c
  [[nodiscard]] Value multiplyAdd(Half half, const Value &a, const Value &b, const Value &c);
  /// Of x, y and z, in each component.
  [[nodiscard]] Value dot(const Value &a, const Value &b);
  [[nodiscard]] Value sum(Half half, const Value &a, const Value &b);
  /// `below` where the chooser's w is less than one half, else `other`.
  [[nodiscard]] Value chosen(Half half, const Value &chooser, const Value &below,
                             const Value &other);
  /// a * b + (1 - a) * c
  [[nodiscard]] Value blended(Half half, const Value &a, const Value &b, const Value &c);
  /// Table RC.4.
  [[nodiscard]] Value mapped(Half half, const Value &value, Mapping mapping);

private:
  [[nodiscard]] ir::Target fresh(Half half);
  [[nodiscard]] Value emit(Half half, ir::Opcode opcode, std::initializer_list<ir::Source> operands,
                           float low, float high);

  ir::Builder &m_builder;
  std::vector<Value> m_literals;
};

} // namespace arbiter::fp::combiners
