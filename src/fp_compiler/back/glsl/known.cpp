#include "fp_compiler/back/glsl/known.h"

#include <algorithm>
#include <cmath>

#include "fp_compiler/ir/reads.h"
#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::glsl {

using ir::AttributeKind;
using ir::Opcode;

namespace {
constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// Beyond what a host's polynomials miss the true function by.
constexpr float kSlack = 1e-3f;

Known between(float lo, float hi, bool number) { return {lo, hi, number}; }

Known hull(const Known &a, const Known &b) {
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi), a.number && b.number};
}

/// Bounds are products of bounds; a zero and an infinity are met in the limit only.
float corner(float a, float b) { return a == 0.0f || b == 0.0f ? 0.0f : a * b; }

Known magnitude(const Known &a) {
  const float low = a.mayBeZero() ? 0.0f : std::min(std::fabs(a.lo), std::fabs(a.hi));
  return {low, std::max(std::fabs(a.lo), std::fabs(a.hi)), a.number};
}

/// The larger one, or the number if one is NaN.
Known larger(const Known &a, const Known &b) {
  if (a.number && b.number)
    return {std::max(a.lo, b.lo), std::max(a.hi, b.hi), true};
  const float lo = a.number ? a.lo : b.number ? b.lo : std::min(a.lo, b.lo);
  return {lo, std::max(a.hi, b.hi), a.number || b.number};
}

Known reciprocal(const Known &a) {
  if (a.mayBeZero()) // of either sign
    return {-kInfinity, kInfinity, a.number};
  return {1.0f / a.hi, 1.0f / a.lo, a.number};
}

Known exponential(const Known &a) {
  return {std::exp2(a.lo) * (1 - kSlack), std::exp2(a.hi) * (1 + kSlack), a.number};
}

Known logarithm(const Known &a) {
  const bool number = a.notNegative();
  return {number ? std::log2(a.lo) - kSlack : -kInfinity,
          a.hi > 0.0f ? std::log2(a.hi) + kSlack : kInfinity, number};
}

/// POW's rules let no NaN of the base through, and nothing below zero.
Known power(const Known &base, const Known &exponent) {
  const bool small = base.hi <= 1.0f && exponent.number && exponent.lo >= 0.0f;
  return {0.0f, small ? 1.0f + kSlack : kInfinity, exponent.finite()};
}

/// The mode's single operations.
class Arithmetic {
public:
  explicit Arithmetic(Numerics numerics) : m_numerics(numerics) {}

  Known product(const Known &a, const Known &b) const {
    const auto [lo, hi] = std::minmax(
        {corner(a.lo, b.lo), corner(a.lo, b.hi), corner(a.hi, b.lo), corner(a.hi, b.hi)});
    const bool harmless = (!a.mayBeZero() || b.finite()) && (!b.mayBeZero() || a.finite());
    return held({lo, hi, a.number && b.number && (harmless || m_numerics != Numerics::Host)});
  }

  Known sum(const Known &a, const Known &b) const {
    const float lo = a.lo + b.lo, hi = a.hi + b.hi;
    const bool bounded = a.finite() || b.finite() || (a.lo > -kInfinity && b.lo > -kInfinity) ||
                         (a.hi < kInfinity && b.hi < kInfinity);
    Known total;
    if (!std::isnan(lo))
      total.lo = lo;
    if (!std::isnan(hi))
      total.hi = hi;
    total.number = a.number && b.number && bounded;
    return held(total);
  }

  /// A sum of products, which a host may fuse or take in another order: where it cancels it is not
  /// told from zero.
  Known blurred(const Known &a) const {
    const float slack = 1e-6f * std::max(std::fabs(a.lo), std::fabs(a.hi));
    Known result = a;
    if (result.lo > 0.0f)
      result.lo = std::max(0.0f, result.lo - slack);
    if (result.hi < 0.0f)
      result.hi = std::min(0.0f, result.hi + slack);
    return result;
  }

  Known dot(const Known4 &a, const Known4 &b, std::size_t count) const {
    Known total = product(a[0], b[0]);
    for (std::size_t i = 1; i < count; ++i)
      total = sum(total, product(a[i], b[i]));
    return total;
  }

  /// A host may do LRP as c + a * (b - c).
  Known blend(const Known &a, const Known &b, const Known &c) const {
    const Known rest = sum(knownNumber(1.0f), negated(a));
    const Known result = sum(product(a, b), product(rest, c));
    const float slack = 1e-6f * std::max(std::fabs(result.lo), std::fabs(result.hi));
    const bool allFinite = a.finite() && b.finite() && c.finite();
    return {std::isinf(result.lo) ? result.lo : result.lo - slack,
            std::isinf(result.hi) ? result.hi : result.hi + slack,
            result.number && (allFinite || m_numerics != Numerics::Host)};
  }

  /// A result as a register holds it; rounding keeps the order of values.
  Known held(const Known &a) const {
    if (m_numerics == Numerics::Fp24)
      return {fp24::rounded(a.lo), fp24::rounded(a.hi), a.number};
    return {a.lo > 0.0f ? ir::flushed(a.lo) : a.lo, a.hi < 0.0f ? ir::flushed(a.hi) : a.hi,
            a.number};
  }

private:
  Numerics m_numerics;
};

Known component(const Arithmetic &unit, Opcode op, const Known &a, const Known &b, const Known &c) {
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
  case Opcode::Sge:
  case Opcode::Slt:
    return knownBetween(0.0f, 1.0f);
  case Opcode::Sub:
    return unit.sum(a, negated(b));
  default:
    return {};
  }
}

Known4 all(const Known &a) { return {a, a, a, a}; }

} // namespace

Known knownNumber(float value) { return std::isnan(value) ? Known{} : between(value, value, true); }
Known knownBetween(float lo, float hi) { return between(lo, hi, true); }
Known negated(const Known &value) { return {-value.hi, -value.lo, value.number}; }
Known saturated(const Known &value) {
  if (!value.number)
    return knownBetween(0.0f, 1.0f);
  return knownBetween(std::clamp(value.lo, 0.0f, 1.0f), std::clamp(value.hi, 0.0f, 1.0f));
}

Known knownAttribute(const ir::Attribute &attribute, ir::Language language, int component,
                     Numerics numerics) {
  constexpr float kLargest = 65536.0f;
  const bool vertex = language == ir::Language::ArbVertex;
  switch (attribute.kind) {
  case AttributeKind::ColorPrimary:
  case AttributeKind::ColorSecondary:
    if (vertex)
      return {};
    return numerics == Numerics::Fp24 ? knownBetween(0.0f, 1.0f)
                                      : knownBetween(-kLargest, kLargest);
  case AttributeKind::FogCoord:
    return component == 0 ? Known{} : knownNumber(component == 3 ? 1.0f : 0.0f);
  case AttributeKind::Position: // z is within the depth range; w is 1/w of the clip coordinates
    if (vertex || component == 3)
      return {};
    return component == 2 ? knownBetween(0.0f, 1.0f) : knownBetween(-kLargest, kLargest);
  case AttributeKind::Normal:
    return component == 3 ? knownNumber(1.0f) : Known{};
  case AttributeKind::TexCoord:
  case AttributeKind::Generic:
    break;
  }
  return {};
}

Known4 knownResult(const ir::Instruction &instruction, const std::array<Known4, 3> &operands,
                   Numerics numerics) {
  const Arithmetic unit(numerics);
  const Known4 &a = operands[0], &b = operands[1], &c = operands[2];
  const Known zero = knownNumber(0.0f), one = knownNumber(1.0f);
  switch (instruction.op) {
  case Opcode::Cos:
  case Opcode::Sin:
    return all(between(-1 - kSlack, 1 + kSlack, a[0].finite()));
  case Opcode::Scs: {
    const Known wave = between(-1 - kSlack, 1 + kSlack, a[0].finite());
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
  case Opcode::Lit: { // its exponent is clamped
    const Known exponent = knownBetween(a[3].notNegative() ? 0.0f : -128.0f, 128.0f);
    return {one, larger(a[0], zero), unit.held(power(a[1], exponent)), one};
  }
  case Opcode::Pow:
    return all(unit.held(power(a[0], b[0])));
  case Opcode::Rcp:
    return all(unit.held(reciprocal(a[0])));
  case Opcode::Rsq: {
    const Known from = magnitude(a[0]);
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
  case Opcode::Txb: // a texture may hold any float; a comparison gives 0 to 1
    return ir::isShadow(instruction.target) ? all(knownBetween(0.0f, 1.0f)) : Known4{};
  case Opcode::Exp:
  case Opcode::Log:
  case Opcode::Arl:
  case Opcode::Kil:
    return {};
  default:
    break;
  }
  Known4 result;
  for (std::size_t i = 0; i < 4; ++i)
    result[i] = component(unit, instruction.op, a[i], b[i], c[i]);
  return result;
}

} // namespace arbiter::fp::glsl
