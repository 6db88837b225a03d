#include "reference.h"

#include <cmath>
#include <limits>

#include "exact.h"

namespace arbiter::fp::proof {

using ir::Opcode;
using ir::Vec4;

namespace {
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const double kGreatest = std::ldexp(2.0 - std::ldexp(1.0, -16), 63);
const double kLeast = std::ldexp(1.0, -62);

double signedAs(double size, bool negative) { return negative ? -size : size; }

/// Brings a number with 17 significant bits into the range of the format.
float ranged(double value, double beyond) {
  const bool negative = std::signbit(value);
  if (std::fabs(value) > kGreatest)
    return float(signedAs(beyond, negative));
  return std::fabs(value) < kLeast ? float(signedAs(0.0, negative)) : float(value);
}

/// Rounds an exact result other than zero as one step does.
float step(const Exact &exact) {
  const double single = exact.rounded(24);
  return std::fabs(single) >= 0x1p128 ? float(signedAs(kInfinity, exact.negative()))
                                      : nearest(single);
}

long double evaluated(Opcode op, long double x) {
  switch (op) {
  case Opcode::Cos:
    return std::cos(x);
  case Opcode::Sin:
    return std::sin(x);
  case Opcode::Ex2:
    return std::exp2(x);
  default: // LG2
    return std::log2(x);
  }
}

/// Rounds to a single, by conversion, and then to 24 bits.
float stepped(long double value) {
  const float single = float(value);
  return std::isfinite(single) ? nearest(double(single)) : single;
}
} // namespace

float valueOf(std::uint32_t pattern) {
  const bool negative = pattern >> 23 & 1;
  const int exponent = int(pattern >> 16 & 127);
  const int mantissa = int(pattern & 0xFFFF);
  double size = std::ldexp(65536.0 + mantissa, exponent - 63 - 16);
  if (exponent == 0)
    size = 0;
  if (exponent == 127)
    size = mantissa == 0 ? double(kInfinity) : double(kNan);
  return float(signedAs(size, negative));
}

float nearest(double value) {
  if (!std::isfinite(value) || value == 0)
    return float(value);
  const Parts parts = partsOf(value); // 53 bits, of which 17 stay
  constexpr std::uint64_t kUnit = std::uint64_t(1) << 36;
  const std::uint64_t rest = parts.mantissa % kUnit;
  std::uint64_t kept = parts.mantissa / kUnit;
  if (rest > kUnit / 2 || (rest == kUnit / 2 && kept % 2 == 1))
    ++kept;
  return ranged(signedAs(std::ldexp(double(kept), parts.exponent + 36), parts.negative), kInfinity);
}

float towardZero(double value) {
  if (!std::isfinite(value) || value == 0)
    return float(value);
  const Parts parts = partsOf(value);
  const double size = std::ldexp(double(parts.mantissa >> 36), parts.exponent + 36);
  return ranged(signedAs(size, parts.negative), kGreatest);
}

float color(float value) {
  if (!(value > 0x1p-13f)) // less than half of 1/4095
    return 0;
  if (value >= 1)
    return 1;
  // This takes three steps on singles, then 24 bits: times 4095, to an integer, times 1/4095.
  const double scaled = exactProduct(value, 4095.0f).rounded(24);
  const double below = std::floor(scaled), rest = scaled - below;
  const auto whole = std::uint32_t(below);
  const std::uint32_t level = rest > 0.5 || (rest == 0.5 && whole % 2 == 1) ? whole + 1 : whole;
  const auto unit = float(exactQuotient(1, 4095, 0).rounded(24));
  return level == 0 ? 0.0f : nearest(exactProduct(float(level), unit).rounded(24));
}

float product(float a, float b) {
  const bool negative = std::signbit(a) != std::signbit(b);
  const bool zero = a == 0 || b == 0;
  if (zero && std::isfinite(a) && std::isfinite(b))
    return float(signedAs(0, negative));
  if (zero)
    return 0.0f;
  if (std::isnan(a) || std::isnan(b))
    return kNan;
  if (std::isinf(a) || std::isinf(b))
    return float(signedAs(kInfinity, negative));
  return step(exactProduct(a, b));
}

float sum(float a, float b) {
  if (std::isnan(a) || std::isnan(b))
    return kNan;
  if (std::isinf(a) || std::isinf(b))
    return std::isinf(a) && std::isinf(b) && a != b ? kNan : std::isinf(a) ? a : b;
  const Exact exact = exactSum(a, b);
  if (exact.isZero()) // zeros of one sign keep it
    return float(signedAs(0, a == 0 && std::signbit(a) && std::signbit(b)));
  return step(exact);
}

Function function(Opcode op, float x) {
  if (std::isnan(x))
    return {kNan};
  if (op == Opcode::Rcp || op == Opcode::Rsq) {
    const bool negative = op == Opcode::Rcp && std::signbit(x);
    const float size = std::fabs(x);
    if (size == 0 || std::isinf(size))
      return {float(signedAs(size == 0 ? kInfinity : 0, negative))};
    const Exact exact = op == Opcode::Rcp ? exactReciprocal(size) : exactReciprocalRoot(size);
    return {float(signedAs(step(exact), negative))};
  }
  const long double value = evaluated(op, x);
  Function result;
  result.value = result.other = stepped(value);
  if (!std::isfinite(value))
    return result;
  constexpr long double kError = 4 * std::numeric_limits<long double>::epsilon();
  for (const long double factor : {1 - kError, 1 + kError}) {
    const float other = stepped(value * factor);
    if (other != result.value) {
      result.open = true;
      result.other = other;
    }
  }
  return result;
}

namespace {
float maximum(float a, float b) {
  if (std::isnan(a) || std::isnan(b))
    return std::isnan(a) ? b : a;
  if (a == 0 && b == 0)
    return std::signbit(a) && std::signbit(b) ? -0.0f : 0.0f;
  return a > b ? a : b;
}

float floorOf(float x) {
  if (!std::isfinite(x) || std::fabs(x) >= 0x1p17f || x == 0)
    return x;
  const auto whole = std::int64_t(x); // toward zero
  if (x < 0)
    return float(double(x) < double(whole) ? whole - 1 : whole);
  return float(whole);
}

Function power(float a, float b) {
  if (b == 0)
    return {1.0f};
  if (!(a > 0))
    return {0.0f};
  const Function logarithm = function(Opcode::Lg2, a);
  Function result = function(Opcode::Ex2, product(b, logarithm.value));
  result.open = result.open || logarithm.open;
  return result;
}

float blend(float a, float b, float c) { return sum(product(a, b), product(sum(1, -a), c)); }

Vec4 map(const ir::Operands &operands, float (*one)(float, float, float)) {
  Vec4 result = {};
  for (std::size_t i = 0; i < 4; ++i)
    result[i] = one(operands[0][i], operands[1][i], operands[2][i]);
  return result;
}

Vec4 all(float value) { return {value, value, value, value}; }
} // namespace

Result reference(Opcode op, const ir::Operands &operands) {
  const Vec4 &a = operands[0], &b = operands[1];
  const auto dot = [&](std::size_t count) {
    float result = product(a[0], b[0]);
    for (std::size_t i = 1; i < count; ++i)
      result = sum(result, product(a[i], b[i]));
    return result;
  };
  const auto minor = [&](std::size_t i, std::size_t j) {
    return sum(product(a[i], b[j]), -product(a[j], b[i]));
  };
  switch (op) {
  case Opcode::Abs:
    return {map(operands, [](float x, float, float) { return std::signbit(x) ? -x : x; })};
  case Opcode::Add:
    return {map(operands, [](float x, float y, float) { return sum(x, y); })};
  case Opcode::Cmp:
    return {map(operands, [](float x, float y, float z) { return x < 0 ? y : z; })};
  case Opcode::Dp3:
    return {all(dot(3))};
  case Opcode::Dp4:
    return {all(dot(4))};
  case Opcode::Dph:
    return {all(sum(dot(3), b[3]))};
  case Opcode::Dst:
    return {{1, product(a[1], b[1]), a[2], b[3]}};
  case Opcode::Flr:
    return {map(operands, [](float x, float, float) { return floorOf(x); })};
  case Opcode::Frc:
    return {map(operands, [](float x, float, float) { return sum(x, -floorOf(x)); })};
  case Opcode::Lit: {
    const float limit = towardZero(128 - 0x1p-17);
    const float exponent = std::isnan(a[3]) ? -limit : std::fmin(std::fmax(a[3], -limit), limit);
    const Function specular = a[0] > 0 ? power(a[1], exponent) : Function{};
    return {{1, maximum(a[0], 0), specular.value, 1}, specular.open};
  }
  case Opcode::Lrp:
    return {map(operands, blend)};
  case Opcode::Mad:
    return {map(operands, [](float x, float y, float z) { return sum(product(x, y), z); })};
  case Opcode::Max:
    return {map(operands, [](float x, float y, float) { return maximum(x, y); })};
  case Opcode::Min:
    return {map(operands, [](float x, float y, float) { return -maximum(-x, -y); })};
  case Opcode::Mov:
  case Opcode::Swz:
    return {a};
  case Opcode::Mul:
    return {map(operands, [](float x, float y, float) { return product(x, y); })};
  case Opcode::Pow: {
    const Function result = power(a[0], b[0]);
    return {all(result.value), result.open};
  }
  case Opcode::Scs: {
    const Function cosine = function(Opcode::Cos, a[0]), sine = function(Opcode::Sin, a[0]);
    return {{cosine.value, sine.value, 0, 0}, cosine.open || sine.open};
  }
  case Opcode::Sge:
    return {map(operands, [](float x, float y, float) { return x >= y ? 1.0f : 0.0f; })};
  case Opcode::Slt:
    return {map(operands, [](float x, float y, float) { return x < y ? 1.0f : 0.0f; })};
  case Opcode::Sub:
    return {map(operands, [](float x, float y, float) { return sum(x, -y); })};
  case Opcode::Xpd:
    return {{minor(1, 2), minor(2, 0), minor(0, 1), 0}};
  default: { // COS EX2 LG2 RCP RSQ SIN
    const Function result = function(op, a[0]);
    return {all(result.value), result.open};
  }
  }
}

} // namespace arbiter::fp::proof
