#include <bit>
#include <cmath>

#include "fp_compiler/hw/r300/lower/emitter.h"

/// Emits MAD, which also serves as copy, sum and product. A constant factor becomes the output
/// modifier if it can.
namespace arbiter::fp::hw::r300 {

namespace {
/// Returns whether |value| is a power of two that the output modifier has.
bool modifierOf(float value, Modifier &modifier) {
  const float size = std::fabs(value);
  modifier = size == 2.0f     ? Modifier::X2
             : size == 4.0f   ? Modifier::X4
             : size == 8.0f   ? Modifier::X8
             : size == 0.25f  ? Modifier::Quarter
             : size == 0.125f ? Modifier::Eighth
                              : Modifier::One;
  return modifier != Modifier::One;
}

/// Returns whether all components of \p mask have one factor that the output modifier has.
bool scaleOf(const Value &value, std::uint8_t mask, float &factor) {
  const Ref &first = value.through[std::size_t(std::countr_zero(mask))];
  Modifier ignored;
  factor = first.value;
  return first.kind == Ref::Kind::Literal && modifierOf(factor, ignored) &&
         isLiteral(value.through, mask, factor);
}
} // namespace

Value Emitter::mad(std::uint8_t mask, const Value &a, const Value &b, const Value &c,
                   const EmitOptions &options) {
  return byHalves(mask, [&](std::uint8_t half) {
    std::array<Value, 3> operands = {a, b, c};
    EmitOptions mine = options;
    float factor = 1.0f;
    if (options.modifier == Modifier::One && isLiteral(c.through, half, 0.0f))
      for (std::size_t i = 0; i < 2; ++i)
        if (mine.modifier == Modifier::One && scaleOf(operands[i], half, factor)) {
          (void)modifierOf(factor, mine.modifier);
          operands[i] = literals(std::copysign(1.0f, factor));
        }
    return componentwise(RgbOp::Mad, AlphaOp::Mad, half, operands, mine);
  });
}

Value Emitter::copy(std::uint8_t mask, const Value &value, const EmitOptions &options) {
  // Adding -0 keeps the sign of a zero.
  return mad(mask, value, literals(1.0f), literals(-0.0f), options);
}

} // namespace arbiter::fp::hw::r300
