#pragma once
#include <optional>
#include <vector>

#include "fp_compiler/combiners/state.h"
#include "fp_compiler/ir/builder.h"

namespace arbiter::fp::combiners {

/// The part of a register that a portion computes: a vector in x, y and z, or a scalar in w.
enum class Half : std::uint8_t { Rgb, Alpha };

/// A computed value of one half and its known range. Clamps that cannot change it are not emitted.
struct Value {
  static constexpr float kAny = 3e38f;

  ir::Source source;
  float low = -kAny;
  float high = kAny;
  std::optional<float> literal; ///< the value, if all components are a known constant
  /// For a product with one() in Numerics::Fx9: the other factor. It becomes a register again
  /// without rounding.
  std::optional<ir::Source> timesOne = {};

  /// The value before it was clamped to [low, high]. A second clamp starts from it.
  struct Beneath {
    ir::Source source;
    float low, high;
  };
  std::optional<Beneath> beneath = {};

  [[nodiscard]] bool is(float number) const { return literal && *literal == number; }
};

/// Emits the arithmetic of register combiners as instructions. Every result is a new temporary, so
/// that values never change. Constants are folded.
///
/// In Numerics::Fx9 a register value n / 255 is held as the whole number n, and a product in units
/// of 1 / (255 * 255). Every step is then exact in single precision, whether or not a back end
/// contracts or reorders it. Only the write to a register rounds.
class Values {
public:
  Values(ir::Builder &builder, bool fx9) : m_builder(builder), m_fx9(fx9) {}

  /// Return one and one half, as a register holds them.
  [[nodiscard]] float one() const { return m_fx9 ? 255.0f : 1.0f; }
  [[nodiscard]] float oneHalf() const { return m_fx9 ? 128.0f : 0.5f; }
  /// Returns one, as a product of registers holds it.
  [[nodiscard]] float oneOfProduct() const { return one() * one(); }
  /// Converts a value of other GL state to a register value.
  [[nodiscard]] Value registered(Half half, const Value &given);
  /// Returns (product - one half if `biased`) * scale as a register value, which may be out of
  /// range.
  [[nodiscard]] Value fromProduct(Half half, const Value &product, float scale, bool biased);
  /// Converts a register value to what other GL state expects.
  [[nodiscard]] Value given(Half half, const Value &value);

  [[nodiscard]] Value literal(float number);
  [[nodiscard]] Value atLeast(Half half, const Value &value, float bound);
  [[nodiscard]] Value atMost(Half half, const Value &value, float bound);
  [[nodiscard]] Value clamped(Half half, const Value &value, float low, float high);
  [[nodiscard]] Value negated(const Value &value);
  /// Returns value * scale + bias.
  [[nodiscard]] Value scaled(Half half, const Value &value, float scale, float bias);
  [[nodiscard]] Value product(Half half, const Value &a, const Value &b);
  /// Returns a * b + c.
  [[nodiscard]] Value multiplyAdd(Half half, const Value &a, const Value &b, const Value &c);
  /// Returns the dot product of x, y and z in each component.
  [[nodiscard]] Value dot(const Value &a, const Value &b);
  [[nodiscard]] Value sum(Half half, const Value &a, const Value &b);
  /// Returns `below` if the chooser's w, a register value, is less than one half, else `other`.
  [[nodiscard]] Value chosen(Half half, const Value &chooser, const Value &below,
                             const Value &other);
  /// Returns a * b + (1 - a) * c of registers, as a product.
  [[nodiscard]] Value blended(Half half, const Value &a, const Value &b, const Value &c);
  /// Applies a mapping of table RC.4 to a register value.
  [[nodiscard]] Value mapped(Half half, const Value &value, Mapping mapping);

private:
  [[nodiscard]] ir::Target fresh(Half half);
  [[nodiscard]] Value emit(Half half, ir::Opcode opcode, std::initializer_list<ir::Source> operands,
                           float low, float high);

  /// Returns the register whose product with one() is \p product.
  [[nodiscard]] Value registerOf(const Value &product) const;
  [[nodiscard]] Value roundedDown(Half half, const Value &value);

  ir::Builder &m_builder;
  bool m_fx9;
  std::vector<Value> m_literals;
};

} // namespace arbiter::fp::combiners
