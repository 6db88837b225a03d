#include "fp_compiler/testing/interval.h"

#include "fp_compiler/testing/random.h"

namespace arbiter::fp::testing {

using ir::Opcode;

namespace {
using Ranges = std::array<Interval, 4>;

Interval hull(const Interval &a, const Interval &b) {
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}
Interval absolute(const Interval &a) {
  return a.lo >= 0 ? a : a.hi <= 0 ? -a : Interval{0, a.magnitude()};
}
Interval power(const Interval &a, const Interval &b) {
  const auto [low, high] = std::minmax(
      {std::pow(a.lo, b.lo), std::pow(a.lo, b.hi), std::pow(a.hi, b.lo), std::pow(a.hi, b.hi)});
  return {low, high};
}
Ranges all(const Interval &a) { return {a, a, a, a}; }

Interval component(Opcode op, const Interval &a, const Interval &b, const Interval &c) {
  switch (op) {
  case Opcode::Abs:
    return absolute(a);
  case Opcode::Add:
    return a + b;
  case Opcode::Cmp:
    return hull(b, c);
  case Opcode::Flr:
    return {std::floor(a.lo), std::floor(a.hi)};
  case Opcode::Frc:
  case Opcode::Sge:
  case Opcode::Slt:
    return {0, 1};
  case Opcode::Lrp:
    return a * b + (Interval{1, 1} + -a) * c;
  case Opcode::Mad:
    return a * b + c;
  case Opcode::Max:
    return {std::max(a.lo, b.lo), std::max(a.hi, b.hi)};
  case Opcode::Min:
    return {std::min(a.lo, b.lo), std::min(a.hi, b.hi)};
  case Opcode::Mul:
    return a * b;
  case Opcode::Sub:
    return a + -b;
  default:
    return a; // MOV, SWZ
  }
}
} // namespace

Interval attributeRange(ir::AttributeKind kind, int index) {
  switch (kind) {
  case ir::AttributeKind::ColorPrimary:
    return {InputRanges::kColorLow, InputRanges::kColorHigh};
  case ir::AttributeKind::ColorSecondary:
    return {0, 1}; // the host decides whether the fourth component is 0 or 1
  case ir::AttributeKind::TexCoord:
    if (index == 3)
      return {InputRanges::kTexCoordQLow, InputRanges::kTexCoordQHigh};
    return {InputRanges::kTexCoordLow, InputRanges::kTexCoordHigh};
  case ir::AttributeKind::FogCoord:
    return {0, 2};
  case ir::AttributeKind::Position:
    return {0, index < 2 ? InputRanges::kPositionHigh : 1.0f};
  case ir::AttributeKind::Facing:
    return {-1, 1};
  case ir::AttributeKind::Normal:
  case ir::AttributeKind::Generic:
    return {InputRanges::kTexCoordLow, InputRanges::kTexCoordHigh};
  }
  return {};
}

Interval vertexAttributeRange(const ir::Attribute &attribute, int index) {
  const bool position = attribute.kind == ir::AttributeKind::Position ||
                        (attribute.kind == ir::AttributeKind::Generic && attribute.index == 0);
  if (position)
    return index == 3 ? Interval{1, 1} : Interval{-1, 1};
  if (attribute.kind == ir::AttributeKind::Normal && index == 3)
    return {1, 1};
  return attributeRange(attribute.kind, index);
}

std::array<Interval, 4> rangesOf(Opcode op, const std::array<Ranges, 3> &operands) {
  const Ranges &a = operands[0], &b = operands[1];
  const Interval dot3 = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  switch (op) {
  case Opcode::Dp3:
    return all(dot3);
  case Opcode::Dp4:
    return all(dot3 + a[3] * b[3]);
  case Opcode::Dph:
    return all(dot3 + b[3]);
  case Opcode::Dst:
    return {Interval{1, 1}, a[1] * b[1], a[2], b[3]};
  case Opcode::Cos:
  case Opcode::Sin:
    return all({-1, 1});
  case Opcode::Scs:
    return {Interval{-1, 1}, Interval{-1, 1}, Interval{0, 0}, Interval{0, 0}};
  case Opcode::Ex2:
    return all({std::exp2(a[0].lo), std::exp2(a[0].hi)});
  case Opcode::Lg2:
    return all({std::log2(a[0].lo), std::log2(a[0].hi)});
  case Opcode::Exp:
    return {Interval{std::exp2(std::floor(a[0].lo)), std::exp2(a[0].hi)}, Interval{0, 1},
            Interval{std::exp2(a[0].lo), std::exp2(a[0].hi)}, Interval{1, 1}};
  case Opcode::Log: {
    const Interval from = absolute(a[0]);
    const Interval log = {std::log2(from.lo), std::log2(from.hi)};
    return {Interval{std::floor(log.lo), log.hi}, Interval{1, 2}, log, Interval{1, 1}};
  }
  case Opcode::Rcp:
    return all({1 / a[0].hi, 1 / a[0].lo});
  case Opcode::Rsq: {
    const Interval from = absolute(a[0]);
    return all({1 / std::sqrt(from.hi), 1 / std::sqrt(from.lo)});
  }
  case Opcode::Pow:
    return all(power(a[0], b[0]));
  case Opcode::Lit: {
    const Interval base = {std::max(a[1].lo, 0.0f), std::max(a[1].hi, 0.0f)};
    const Interval specular = power(base, a[3]);
    return {Interval{1, 1}, Interval{std::max(a[0].lo, 0.0f), std::max(a[0].hi, 0.0f)},
            Interval{0, specular.hi}, Interval{1, 1}};
  }
  case Opcode::Xpd: {
    const auto minor = [&](std::size_t i, std::size_t j) { return a[i] * b[j] + -(a[j] * b[i]); };
    return {minor(1, 2), minor(2, 0), minor(0, 1), Interval{0, 0}};
  }
  default:
    break;
  }
  Ranges result;
  for (std::size_t i = 0; i < 4; ++i)
    result[i] = component(op, a[i], b[i], operands[2][i]);
  return result;
}

} // namespace arbiter::fp::testing
