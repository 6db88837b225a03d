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
  /// By Numerics::Fx9, of a product: the register that one() is the other factor of. Nothing of it
  /// is rounded where it becomes a register again.
  std::optional<ir::Source> timesOne = {};

  /// What it is a clamped copy of, to low and high: what is clamped again begins there.
  struct Beneath {
    ir::Source source;
    float low, high;
  };
  std::optional<Beneath> beneath = {};

  [[nodiscard]] bool is(float number) const { return literal && *literal == number; }
};

/// The arithmetic of register combiners as instructions. Every result is a new temporary, so that
/// values stay what they were; what is known while compiling is not computed.
///
/// By Numerics::Fx9 a register's value n / 255 is the whole number n, and a product's the whole
/// number of 255 * 255ths, so that every step is exact in singles, however a back end contracts or
/// orders it, and the one rounding is where a register is written.
class Values {
public:
  Values(ir::Builder &builder, bool fx9) : m_builder(builder), m_fx9(fx9) {}

  /// One, and one half, as a register holds them.
  [[nodiscard]] float one() const { return m_fx9 ? 255.0f : 1.0f; }
  [[nodiscard]] float oneHalf() const { return m_fx9 ? 128.0f : 0.5f; }
  /// One, as a product of registers.
  [[nodiscard]] float oneOfProduct() const { return one() * one(); }
  /// What the rest of GL gives, as a register holds it.
  [[nodiscard]] Value registered(Half half, const Value &given);
  /// (product - one half if `biased`) * scale as a register, which it may be out of the range of.
  [[nodiscard]] Value fromProduct(Half half, const Value &product, float scale, bool biased);
  /// The register as the rest of GL takes it.
  [[nodiscard]] Value given(Half half, const Value &value);

  [[nodiscard]] Value literal(float number);
  [[nodiscard]] Value atLeast(Half half, const Value &value, float bound);
  [[nodiscard]] Value atMost(Half half, const Value &value, float bound);
  [[nodiscard]] Value clamped(Half half, const Value &value, float low, float high);
  [[nodiscard]] Value negated(const Value &value);
  /// value * scale + bias
  [[nodiscard]] Value scaled(Half half, const Value &value, float scale, float bias);
  [[nodiscard]] Value product(Half half, const Value &a, const Value &b);
  /// a * b + c
  [[nodiscard]] Value multiplyAdd(Half half, const Value &a, const Value &b, const Value &c);
  /// Of x, y and z, in each component.
  [[nodiscard]] Value dot(const Value &a, const Value &b);
  [[nodiscard]] Value sum(Half half, const Value &a, const Value &b);
  /// `below` where the chooser's w, a register, is less than one half, else `other`.
  [[nodiscard]] Value chosen(Half half, const Value &chooser, const Value &below,
                             const Value &other);
  /// a * b + (1 - a) * c of registers, as a product
  [[nodiscard]] Value blended(Half half, const Value &a, const Value &b, const Value &c);
  /// Table RC.4, of a register.
  [[nodiscard]] Value mapped(Half half, const Value &value, Mapping mapping);

private:
  [[nodiscard]] ir::Target fresh(Half half);
  [[nodiscard]] Value emit(Half half, ir::Opcode opcode, std::initializer_list<ir::Source> operands,
                           float low, float high);

  /// The register whose product with one() the value is.
  [[nodiscard]] Value registerOf(const Value &product) const;
  [[nodiscard]] Value roundedDown(Half half, const Value &value);

  ir::Builder &m_builder;
  bool m_fx9;
  std::vector<Value> m_literals;
};

} // namespace arbiter::fp::combiners
