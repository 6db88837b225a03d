#include "fp_compiler/analysis/value_range.h"

#include <algorithm>
#include <cmath>

#include "fp_compiler/ir/reads.h"
#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::analysis {

using ir::AttributeKind;
using ir::Opcode;

namespace {
constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// Upper bound of the error of the host's polynomial approximations.
constexpr float kSlack = 1e-3f;

ValueRange between(float lo, float hi, bool number) { return {lo, hi, number}; }

ValueRange hull(const ValueRange &a, const ValueRange &b) {
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi), a.number && b.number};
}

/// Multiplies two bounds. A bound of infinity is never reached, so zero times infinity is 0 here.
float corner(float a, float b) { return a == 0.0f || b == 0.0f ? 0.0f : a * b; }

ValueRange magnitude(const ValueRange &a) {
  const float low = a.mayBeZero() ? 0.0f : std::min(std::fabs(a.lo), std::fabs(a.hi));
  return {low, std::max(std::fabs(a.lo), std::fabs(a.hi)), a.number};
}

/// Returns the range of the larger value, or of the other value if one is NaN.
ValueRange larger(const ValueRange &a, const ValueRange &b) {
  if (a.number && b.number)
    return {std::max(a.lo, b.lo), std::max(a.hi, b.hi), true};
  const float lo = a.number ? a.lo : b.number ? b.lo : std::min(a.lo, b.lo);
  return {lo, std::max(a.hi, b.hi), a.number || b.number};
}

ValueRange reciprocal(const ValueRange &a) {
  if (a.mayBeZero()) // the zero may have either sign
    return {-kInfinity, kInfinity, a.number};
  return {1.0f / a.hi, 1.0f / a.lo, a.number};
}

ValueRange exponential(const ValueRange &a) {
  return {std::exp2(a.lo) * (1 - kSlack), std::exp2(a.hi) * (1 + kSlack), a.number};
}

ValueRange logarithm(const ValueRange &a) {
  const bool number = a.notNegative();
  return {number ? std::log2(a.lo) - kSlack : -kInfinity,
          a.hi > 0.0f ? std::log2(a.hi) + kSlack : kInfinity, number};
}

/// Returns the range of POW. The result of POW is never below zero, and a NaN base gives no NaN.
ValueRange power(const ValueRange &base, const ValueRange &exponent) {
  const bool small = base.hi <= 1.0f && exponent.number && exponent.lo >= 0.0f;
  return {0.0f, small ? 1.0f + kSlack : kInfinity, exponent.finite()};
}

/// Range arithmetic for single operations in one numerics mode.
class Arithmetic {
public:
  explicit Arithmetic(Numerics numerics) : m_numerics(numerics) {}

  ValueRange product(const ValueRange &a, const ValueRange &b) const {
    const auto [lo, hi] = std::minmax(
        {corner(a.lo, b.lo), corner(a.lo, b.hi), corner(a.hi, b.lo), corner(a.hi, b.hi)});
    const bool harmless = (!a.mayBeZero() || b.finite()) && (!b.mayBeZero() || a.finite());
    return held({lo, hi, a.number && b.number && (harmless || m_numerics != Numerics::Host)});
  }

  ValueRange sum(const ValueRange &a, const ValueRange &b) const {
    const float lo = a.lo + b.lo, hi = a.hi + b.hi;
    const bool bounded = a.finite() || b.finite() || (a.lo > -kInfinity && b.lo > -kInfinity) ||
                         (a.hi < kInfinity && b.hi < kInfinity);
    ValueRange total;
    if (!std::isnan(lo))
      total.lo = lo;
    if (!std::isnan(hi))
      total.hi = hi;
    total.number = a.number && b.number && bounded;
    return held(total);
  }

  /// Widens the range of a sum of products. A host may fuse or reorder it, so that cancellation may
  /// give zero.
  ValueRange blurred(const ValueRange &a) const {
    const float slack = 1e-6f * std::max(std::fabs(a.lo), std::fabs(a.hi));
    ValueRange result = a;
    if (result.lo > 0.0f)
      result.lo = std::max(0.0f, result.lo - slack);
    if (result.hi < 0.0f)
      result.hi = std::min(0.0f, result.hi + slack);
    return result;
  }

  ValueRange dot(const ValueRange4 &a, const ValueRange4 &b, std::size_t count) const {
    ValueRange total = product(a[0], b[0]);
    for (std::size_t i = 1; i < count; ++i)
      total = sum(total, product(a[i], b[i]));
    return total;
  }

  /// Returns the range of LRP. A host may compute it as c + a * (b - c).
  ValueRange blend(const ValueRange &a, const ValueRange &b, const ValueRange &c) const {
    const ValueRange rest = sum(rangeOfNumber(1.0f), negated(a));
    const ValueRange result = sum(product(a, b), product(rest, c));
    const float slack = 1e-6f * std::max(std::fabs(result.lo), std::fabs(result.hi));
    const bool allFinite = a.finite() && b.finite() && c.finite();
    return {std::isinf(result.lo) ? result.lo : result.lo - slack,
            std::isinf(result.hi) ? result.hi : result.hi + slack,
            result.number && (allFinite || m_numerics != Numerics::Host)};
  }

  /// Returns the range of a result as a register stores it. Rounding is monotonic, so bounds stay
  /// bounds.
  ValueRange held(const ValueRange &a) const {
    if (m_numerics == Numerics::Fp24)
      return {fp24::rounded(a.lo), fp24::rounded(a.hi), a.number};
    return {a.lo > 0.0f ? ir::flushed(a.lo) : a.lo, a.hi < 0.0f ? ir::flushed(a.hi) : a.hi,
            a.number};
  }

private:
  Numerics m_numerics;
};

ValueRange component(const Arithmetic &unit, Opcode op, const ValueRange &a, const ValueRange &b,
                     const ValueRange &c) {
  switch (op) {
  case Opcode::Abs:
    return magnitude(a);
  case Opcode::Add:
    return unit.sum(a, b);
  case Opcode::Cmp:
    return hull(b, c);
  case Opcode::Flr:
    return {std::floor(a.lo), std::floor(a.hi), a.number};
  case Opcode::Frc:
    return {0.0f, 1.0f, a.finite()};
  case Opcode::Lrp:
    return unit.blend(a, b, c);
  case Opcode::Mad:
    return unit.blurred(unit.sum(unit.product(a, b), c));
  case Opcode::Max:
    return larger(a, b);
  case Opcode::Min:
    return negated(larger(negated(a), negated(b)));
  case Opcode::Mov:
  case Opcode::Swz:
    return a;
  case Opcode::Mul:
    return unit.product(a, b);
  case Opcode::Seq:
  case Opcode::Sge:
  case Opcode::Slt:
  case Opcode::Sne:
    return rangeBetween(0.0f, 1.0f);
  case Opcode::Sub:
    return unit.sum(a, negated(b));
  default:
    return {};
  }
}

ValueRange4 all(const ValueRange &a) { return {a, a, a, a}; }

} // namespace

ValueRange rangeOfNumber(float value) {
  return std::isnan(value) ? ValueRange{} : between(value, value, true);
}
ValueRange rangeBetween(float lo, float hi) { return between(lo, hi, true); }
ValueRange negated(const ValueRange &value) { return {-value.hi, -value.lo, value.number}; }
ValueRange saturated(const ValueRange &value) {
  if (!value.number)
    return rangeBetween(0.0f, 1.0f);
  return rangeBetween(std::clamp(value.lo, 0.0f, 1.0f), std::clamp(value.hi, 0.0f, 1.0f));
}

ValueRange rangeOfAttribute(const ir::Attribute &attribute, ir::Language language, int component,
                            Numerics numerics) {
  constexpr float kLargest = 65536.0f;
  const bool vertex = language == ir::Language::ArbVertex;
  switch (attribute.kind) {
  case AttributeKind::ColorPrimary:
  case AttributeKind::ColorSecondary:
    if (vertex)
      return {};
    return numerics == Numerics::Fp24 ? rangeBetween(0.0f, 1.0f)
                                      : rangeBetween(-kLargest, kLargest);
  case AttributeKind::FogCoord:
    return component == 0 ? ValueRange{} : rangeOfNumber(component == 3 ? 1.0f : 0.0f);
  case AttributeKind::Position: // z is in the depth range; w is 1/w of the clip coordinates
    if (vertex || component == 3)
      return {};
    return component == 2 ? rangeBetween(0.0f, 1.0f) : rangeBetween(-kLargest, kLargest);
  case AttributeKind::Normal:
    return component == 3 ? rangeOfNumber(1.0f) : ValueRange{};
  case AttributeKind::Facing:
    return component == 0 ? rangeBetween(-1.0f, 1.0f) : rangeOfNumber(component == 3 ? 1.0f : 0.0f);
  case AttributeKind::TexCoord:
  case AttributeKind::Generic:
    break;
  }
  return {};
}

ValueRange4 rangeOfResult(const ir::Instruction &instruction,
                          const std::array<ValueRange4, 3> &operands, Numerics numerics) {
  const Arithmetic unit(numerics);
  const ValueRange4 &a = operands[0], &b = operands[1], &c = operands[2];
  const ValueRange zero = rangeOfNumber(0.0f), one = rangeOfNumber(1.0f);
  switch (instruction.op) {
  case Opcode::Cos:
  case Opcode::Sin:
    return all(between(-1 - kSlack, 1 + kSlack, a[0].finite()));
  case Opcode::Scs: {
    const ValueRange wave = between(-1 - kSlack, 1 + kSlack, a[0].finite());
    return {wave, wave, zero, zero};
  }
  case Opcode::Dp3:
    return all(unit.blurred(unit.dot(a, b, 3)));
  case Opcode::Dp4:
    return all(unit.blurred(unit.dot(a, b, 4)));
  case Opcode::Dph:
    return all(unit.blurred(unit.sum(unit.dot(a, b, 3), b[3])));
  case Opcode::Dst:
    return {one, unit.product(a[1], b[1]), a[2], b[3]};
  case Opcode::Ex2:
    return all(unit.held(exponential(a[0])));
  case Opcode::Lg2:
    return all(unit.held(logarithm(a[0])));
  case Opcode::Lit: { // LIT clamps its exponent
    const ValueRange exponent = rangeBetween(a[3].notNegative() ? 0.0f : -128.0f, 128.0f);
    return {one, larger(a[0], zero), unit.held(power(a[1], exponent)), one};
  }
  case Opcode::Pow:
    return all(unit.held(power(a[0], b[0])));
  case Opcode::Rcp:
    return all(unit.held(reciprocal(a[0])));
  case Opcode::Rsq: {
    const ValueRange from = magnitude(a[0]);
    return all(unit.held(
        {(1 - kSlack) / std::sqrt(from.hi), (1 + kSlack) / std::sqrt(from.lo), from.number}));
  }
  case Opcode::Xpd: {
    const auto minor = [&](std::size_t i, std::size_t j) {
      return unit.blurred(unit.sum(unit.product(a[i], b[j]), negated(unit.product(a[j], b[i]))));
    };
    return {minor(1, 2), minor(2, 0), minor(0, 1), zero};
  }
  case Opcode::Tex:
  case Opcode::Txp:
  case Opcode::Txb:
  case Opcode::Txd:
  case Opcode::Txl: // a texture may hold any float; a comparison gives 0 to 1
    return ir::isShadow(instruction.target) ? all(rangeBetween(0.0f, 1.0f)) : ValueRange4{};
  case Opcode::Exp:
  case Opcode::Log:
  case Opcode::Arl:
  case Opcode::Kil:
    return {};
  default:
    break;
  }
  ValueRange4 result;
  for (std::size_t i = 0; i < 4; ++i)
    result[i] = component(unit, instruction.op, a[i], b[i], c[i]);
  return result;
}

} // namespace arbiter::fp::analysis
