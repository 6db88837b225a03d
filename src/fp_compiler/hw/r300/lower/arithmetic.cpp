#include "fp_compiler/hw/r300/lower/arithmetic.h"

#include <cmath>
#include <numbers>

namespace arbiter::fp::hw::r300 {

namespace {
constexpr float kInverseTurn = float(0.5 / std::numbers::pi);
/// Weight of the second parabola in s + p*(s|s| - s). The error of the sine stays below 0.00095.
constexpr float kSharpness = 0.224f;
constexpr float kLitLimit = 128.0f - 0x1p-17f;

/// Returns the magnitude of the value.
Ref absoluteOf(Ref ref) {
  if (ref.kind == Ref::Kind::Literal) {
    ref.value = std::fabs(ref.value);
  } else {
    ref.absolute = true;
    ref.negate = false;
  }
  return ref;
}
} // namespace

Value Arithmetic::copied(std::uint8_t mask, const Value &value, const EmitOptions &options) {
  Value result = m_emit.copy(mask, value, options);
  if (!options.clamp)
    result.through = value.through;
  return result;
}

Value Arithmetic::computed(ir::Opcode op, std::uint8_t mask, const std::array<Value, 3> &s,
                           const EmitOptions &options) {
  const Value one = literals(1.0f), none = literals(-0.0f);
  const std::span<const Value> all(s);
  switch (op) {
  case ir::Opcode::Abs: {
    Value value = s[0];
    for (std::size_t c = 0; c < 4; ++c) {
      value.direct[c] = absoluteOf(value.direct[c]);
      value.through[c] = absoluteOf(value.through[c]);
    }
    return copied(mask, value, options);
  }
  case ir::Opcode::Mov:
  case ir::Opcode::Swz:
    return copied(mask, s[0], options);
  case ir::Opcode::Add:
    return m_emit.mad(mask, s[0], one, s[1], options);
  case ir::Opcode::Sub:
    return m_emit.mad(mask, s[0], one, negated(s[1]), options);
  case ir::Opcode::Mul:
    return m_emit.mad(mask, s[0], s[1], none, options);
  case ir::Opcode::Mad:
    return m_emit.mad(mask, s[0], s[1], s[2], options);
  case ir::Opcode::Lrp:
    return m_emit.lerp(mask, s[0], s[1], s[2], options);
  case ir::Opcode::Cmp: {
    const std::array<Value, 3> operands = {s[2], s[1], s[0]};
    return m_emit.componentwise(RgbOp::Cmp, AlphaOp::Cmp, mask, operands, options);
  }
  case ir::Opcode::Min:
    return m_emit.componentwise(RgbOp::Min, AlphaOp::Min, mask, all.first(2), options);
  case ir::Opcode::Max:
    return m_emit.componentwise(RgbOp::Max, AlphaOp::Max, mask, all.first(2), options);
  case ir::Opcode::Frc:
    return m_emit.componentwise(RgbOp::Frc, AlphaOp::Frc, mask, all.first(1), options);
  case ir::Opcode::Flr: {
    const Value rest = m_emit.componentwise(RgbOp::Frc, AlphaOp::Frc, mask, all.first(1), {});
    return m_emit.mad(mask, s[0], one, negated(rest), options);
  }
  case ir::Opcode::Sge:
    return m_emit.compare(mask, s[0], s[1], 0.0f, 1.0f, options);
  case ir::Opcode::Slt:
    return m_emit.compare(mask, s[0], s[1], 1.0f, 0.0f, options);
  case ir::Opcode::Dp3:
    return m_emit.dot(RgbOp::Dp3, mask, s[0], s[1], options);
  case ir::Opcode::Dp4:
    return m_emit.dot(RgbOp::Dp4, mask, s[0], s[1], options);
  case ir::Opcode::Dph: {
    Value first = s[0];
    first.direct[3] = first.through[3] = literal(1.0f);
    return m_emit.dot(RgbOp::Dp4, mask, first, s[1], options);
  }
  case ir::Opcode::Ex2:
    return m_emit.scalar(AlphaOp::Ex2, mask, s[0], options);
  case ir::Opcode::Lg2:
    return m_emit.scalar(AlphaOp::Lg2, mask, s[0], options);
  case ir::Opcode::Rcp:
    return m_emit.scalar(AlphaOp::Rcp, mask, s[0], options);
  case ir::Opcode::Rsq:
    return m_emit.scalar(AlphaOp::Rsq, mask, s[0], options);
  case ir::Opcode::Pow: {
    const Value logarithm = m_emit.scalar(AlphaOp::Lg2, 8, s[0], {});
    return m_emit.scalar(AlphaOp::Ex2, mask, m_emit.mad(8, logarithm, s[1], none, {}), options);
  }
  case ir::Opcode::Sin:
    return turned(8, mask, s[0], literals(0.5f), options);
  case ir::Opcode::Cos:
    return turned(8, mask, s[0], literals(0.75f), options);
  case ir::Opcode::Scs: {
    Value phase = literals(0.5f);
    phase.direct[0] = phase.through[0] = literal(0.75f);
    Value result;
    if (mask & 3)
      result = turned(mask & 3, mask & 3, s[0], phase, options);
    return with(result, mask & 12, literals(0.0f), options);
  }
  case ir::Opcode::Xpd: {
    const auto rotated = [](const Value &value, bool left) {
      Value result = value;
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t from = (c + (left ? 1 : 2)) % 3;
        result.direct[c] = value.direct[from];
        result.through[c] = value.through[from];
      }
      return result;
    };
    Value result;
    if (const auto rgb = std::uint8_t(mask & 7)) {
      const Value second = m_emit.mad(rgb, rotated(s[0], false), rotated(s[1], true), none, {});
      result = m_emit.mad(rgb, rotated(s[0], true), rotated(s[1], false), negated(second), options);
    }
    return with(result, mask & 8, literals(0.0f), options);
  }
  case ir::Opcode::Dst: {
    Value result;
    if (mask & 2)
      result = m_emit.mad(2, s[0], s[1], none, options);
    result = with(result, mask & 4, s[0], options);
    result = with(result, mask & 8, s[1], options);
    return with(result, mask & 1, one, options);
  }
  case ir::Opcode::Lit:
    return lit(mask, s[0], options);
  case ir::Opcode::Tex:
  case ir::Opcode::Txp:
  case ir::Opcode::Txb:
#define FP_NV_OP(Enumerator, ...) case ir::Opcode::Enumerator:
#define FP_NV_WORD(Enumerator, ...) case ir::Opcode::Enumerator:
#include "fp_compiler/ir/ops.def"
  case ir::Opcode::Kil:
  case ir::Opcode::Arl:
  case ir::Opcode::Exp:
  case ir::Opcode::Log:
    break; // not arithmetic, or not of a fragment language
  }
  return literals(0.0f);
}

/// Returns \p result with a copy of \p value in the components of \p mask.
Value Arithmetic::with(Value result, int mask, const Value &value, const EmitOptions &options) {
  if (mask == 0)
    return result;
  const Value copy = copied(std::uint8_t(mask), value, options);
  for (std::size_t c = 0; c < 4; ++c)
    if (mask >> c & 1) {
      result.direct[c] = copy.direct[c];
      result.through[c] = copy.through[c];
    }
  return result;
}

/// Returns sin(2 pi (x / 2 pi + phase - 1/2)). FRC reduces the angle to one turn. One parabola is
/// within 0.06 of the sine, and a second one corrects it.
/// \param work the components that hold the intermediate values
Value Arithmetic::turned(std::uint8_t work, std::uint8_t mask, const Value &x, const Value &phase,
                         const EmitOptions &options) {
  const Value turn = m_emit.mad(work, x, literals(kInverseTurn), phase, {});
  const Value f =
      m_emit.componentwise(RgbOp::Frc, AlphaOp::Frc, work, std::span<const Value>(&turn, 1), {});
  Value s = m_emit.arch(work, f, {});
  Value size = s;
  for (std::size_t c = 0; c < 4; ++c)
    size.direct[c] = size.through[c] = absoluteOf(s.direct[c]);
  Value bend = m_emit.mad(work, s, size, negated(s), {});
  if (work == 8) {
    s = broadcast(s, 3);
    bend = broadcast(bend, 3);
  }
  return m_emit.mad(mask, bend, literals(kSharpness), s, options);
}

Value Arithmetic::lit(std::uint8_t mask, const Value &s, const EmitOptions &options) {
  const Value zero = literals(0.0f), x = broadcast(s, 0);
  Value result;
  if (mask & 4) {
    const std::array<Value, 2> high = {broadcast(s, 3), literals(kLitLimit)};
    const std::array<Value, 2> low = {m_emit.componentwise(RgbOp::Min, AlphaOp::Min, 1, high, {}),
                                      literals(-kLitLimit)};
    const Value exponent = m_emit.componentwise(RgbOp::Max, AlphaOp::Max, 1, low, {});
    const std::array<Value, 2> base = {broadcast(s, 1), zero};
    const Value logarithm = m_emit.scalar(
        AlphaOp::Lg2, 8, m_emit.componentwise(RgbOp::Max, AlphaOp::Max, 8, base, {}), {});
    const Value product = m_emit.mad(8, logarithm, broadcast(exponent, 0), literals(-0.0f), {});
    const Value power = m_emit.scalar(AlphaOp::Ex2, 8, product, {});
    const std::array<Value, 3> choice = {zero, broadcast(power, 3), negated(x)};
    const Value z = m_emit.componentwise(RgbOp::Cmp, AlphaOp::Cmp, 4, choice, options);
    result.direct[2] = result.through[2] = z.direct[2];
  }
  if (mask & 2) {
    const std::array<Value, 2> diffuse = {x, zero};
    const Value y = m_emit.componentwise(RgbOp::Max, AlphaOp::Max, 2, diffuse, options);
    result.direct[1] = result.through[1] = y.direct[1];
  }
  return with(result, mask & 9, literals(1.0f), options);
}

} // namespace arbiter::fp::hw::r300
