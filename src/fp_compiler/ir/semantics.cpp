#include "fp_compiler/ir/semantics.h"

#include <cassert>
#include <cfloat>
#include <cmath>

#include "fp_compiler/ir/packing.h"

namespace arbiter::fp::ir {

namespace {
Vec4 all(float value) { return {value, value, value, value}; }

template <typename F> Vec4 map(const Vec4 &a, F function) {
  return {function(a[0]), function(a[1]), function(a[2]), function(a[3])};
}

template <typename F> Vec4 zip(const Vec4 &a, const Vec4 &b, F function) {
  return {function(a[0], b[0]), function(a[1], b[1]), function(a[2], b[2]), function(a[3], b[3])};
}

template <typename F> Vec4 zip(const Vec4 &a, const Vec4 &b, const Vec4 &c, F function) {
  return {function(a[0], b[0], c[0]), function(a[1], b[1], c[1]), function(a[2], b[2], c[2]),
          function(a[3], b[3], c[3])};
}

constexpr auto kCosine = [](auto x) { return std::cos(x); };
constexpr auto kSine = [](auto x) { return std::sin(x); };
constexpr auto kExp2 = [](auto x) { return std::exp2(x); };
constexpr auto kLog2 = [](auto x) { return std::log2(x); };
constexpr auto kReciprocalRoot = [](auto x) { return 1 / std::sqrt(std::fabs(x)); };

/// The single operations of a mode. result() converts every result. of() applies a function and
/// converts its result.
struct Host {
  static float product(float a, float b) { return flushed(a * b); }
  static float sum(float a, float b) { return flushed(a + b); }
  static float sum(float x, float y, float z) { return sum(sum(z, y), x); }
  static float sum(float x, float y, float z, float w) { return sum(sum(sum(w, z), y), x); }
  static float homogeneous(float x, float y, float z, float w) { return sum(sum(x, sum(z, w)), y); }
  static float result(float value) { return flushed(value); }
  template <typename F> static float of(F function, float x) { return function(x); }
  /// Requires a > 0 and b != 0. It rounds once, because hosts have pow() as one function.
  static float power(float a, float b) {
    return result(float(std::exp2(double(b) * std::log2(double(a)))));
  }
  static constexpr float kExponentLimit = 127.99999f; // 128 - 2^-17
};

struct Legacy : Host {
  static float product(float a, float b) {
    const float value = a * b;
    if (std::isnan(value) && (a == 0.0f || b == 0.0f))
      return 0.0f;
    return flushed(value);
  }
  static float power(float a, float b) { return a == 1.0f ? 1.0f : Host::power(a, b); }
};

struct Fp24 : Legacy {
  static float product(float a, float b) { return fp24::rounded(Legacy::product(a, b)); }
  static float sum(float a, float b) { return fp24::rounded(a + b); }
  static float sum(float x, float y, float z) { return sum(sum(x, y), z); }
  static float sum(float x, float y, float z, float w) { return sum(sum(x, y, z), w); }
  static float homogeneous(float x, float y, float z, float w) { return sum(x, y, z, w); }
  static float result(float value) { return fp24::rounded(value); }
  /// Computes in double precision, so that the single is correctly rounded. The mode is exact to
  /// the bit.
  template <typename F> static float of(F function, float x) {
    return result(float(function(double(x))));
  }
  static float power(float a, float b) { return of(kExp2, product(b, of(kLog2, a))); }
  static constexpr float kExponentLimit = 0x1.FFFFp6f; // the limit of Host, truncated
};

/// The sums of a mode in vertex programs, which start at the first term.
template <typename Mode> struct Forwards : Mode {
  using Mode::sum;
  static float sum(float x, float y, float z) { return sum(sum(x, y), z); }
  static float sum(float x, float y, float z, float w) { return sum(sum(sum(x, y), z), w); }
  static float homogeneous(float x, float y, float z, float w) { return sum(x, y, z, w); }
};

float maximum(float a, float b) {
  if (std::isnan(a) || std::isnan(b))
    return std::isnan(a) ? b : a;
  if (a == b)
    return std::signbit(a) ? b : a;
  return a > b ? a : b;
}

float minimum(float a, float b) {
  if (std::isnan(a) || std::isnan(b))
    return std::isnan(a) ? b : a;
  if (a == b)
    return std::signbit(a) ? a : b;
  return a < b ? a : b;
}

float fraction(float a) { return a - std::floor(a); }

/// Computes LOG: exponent and mantissa. For 0 it gives (-infinity, 1, -infinity, 1).
Vec4 logarithm(float value) {
  const float magnitude = std::fabs(value);
  const float logarithm = std::log2(magnitude);
  if (magnitude == 0.0f || !std::isfinite(magnitude))
    return {logarithm, 1.0f, logarithm, 1.0f};
  int exponent = 0;
  const float mantissa = std::frexp(magnitude, &exponent); // in [0.5, 1)
  return {float(exponent - 1), mantissa * 2.0f, logarithm, 1.0f};
}

/// Computes the opcodes from a mode's operations. Their results need only result() to round them.
template <typename Mode> struct Unit {
  static Vec4 products(const Vec4 &a, const Vec4 &b) { return zip(a, b, Mode::product); }
  static float dot3(const Vec4 &p) { return Mode::sum(p[0], p[1], p[2]); }
  static float dot4(const Vec4 &p) { return Mode::sum(p[0], p[1], p[2], p[3]); }
  static float homogeneous(const Vec4 &p, float w) {
    return Mode::homogeneous(p[0], p[1], p[2], w);
  }

  static float power(float a, float b) {
    if (b == 0.0f)
      return 1.0f;
    return a > 0.0f ? Mode::power(a, b) : 0.0f;
  }

  static Vec4 lit(const Vec4 &a) {
    const float exponent = minimum(maximum(a[3], -Mode::kExponentLimit), Mode::kExponentLimit);
    return {1.0f, maximum(a[0], 0.0f), a[0] > 0.0f ? power(a[1], exponent) : 0.0f, 1.0f};
  }

  static Vec4 cross(const Vec4 &a, const Vec4 &b) {
    const auto minor = [&](std::size_t i, std::size_t j) {
      return Mode::product(a[i], b[j]) - Mode::product(a[j], b[i]);
    };
    return {minor(1, 2), minor(2, 0), minor(0, 1), 0.0f};
  }

  static float blend(float a, float b, float c) {
    return Mode::sum(Mode::product(a, b), Mode::product(Mode::sum(1.0f, -a), c));
  }

  static Vec4 compute(Opcode op, const Vec4 &a, const Vec4 &b, const Vec4 &c);
  static Vec4 apply(Opcode op, const Operands &operands) {
    return map(compute(op, map(operands[0], flushed), map(operands[1], flushed),
                       map(operands[2], flushed)),
               Mode::result);
  }
};

template <typename Mode>
Vec4 Unit<Mode>::compute(Opcode op, const Vec4 &a, const Vec4 &b, const Vec4 &c) {
  switch (op) {
  case Opcode::Abs:
    return map(a, [](float x) { return std::fabs(x); });
  case Opcode::Add:
    return zip(a, b, [](float x, float y) { return Mode::sum(x, y); });
  case Opcode::Cmp:
    return zip(a, b, c, [](float x, float y, float z) { return x < 0.0f ? y : z; });
  case Opcode::Cos:
    return all(Mode::of(kCosine, a[0]));
  case Opcode::Dp3:
    return all(dot3(products(a, b)));
  case Opcode::Dp4:
    return all(dot4(products(a, b)));
  case Opcode::Dph:
    return all(homogeneous(products(a, b), b[3]));
  case Opcode::Dst:
    return {1.0f, Mode::product(a[1], b[1]), a[2], b[3]};
  case Opcode::Ex2:
    return all(Mode::of(kExp2, a[0]));
  case Opcode::Flr:
    return map(a, [](float x) { return std::floor(x); });
  case Opcode::Frc:
    return map(a, fraction);
  case Opcode::Lg2:
    return all(Mode::of(kLog2, a[0]));
  case Opcode::Lit:
    return lit(a);
  case Opcode::Lrp:
    return zip(a, b, c, blend);
  case Opcode::Mad:
    return zip(a, b, c,
               [](float x, float y, float z) { return Mode::sum(Mode::product(x, y), z); });
  case Opcode::Max:
    return zip(a, b, maximum);
  case Opcode::Min:
    return zip(a, b, minimum);
  case Opcode::Mov:
  case Opcode::Swz:
    return a;
  case Opcode::Mul:
    return zip(a, b, Mode::product);
  case Opcode::Pow:
    return all(power(a[0], b[0]));
  case Opcode::Rcp:
    return all(1.0f / a[0]);
  case Opcode::Rsq:
    return all(Mode::of(kReciprocalRoot, a[0]));
  case Opcode::Scs:
    return {Mode::of(kCosine, a[0]), Mode::of(kSine, a[0]), 0.0f, 0.0f};
  case Opcode::Sge:
    return zip(a, b, [](float x, float y) { return x >= y ? 1.0f : 0.0f; });
  case Opcode::Sin:
    return all(Mode::of(kSine, a[0]));
  case Opcode::Slt:
    return zip(a, b, [](float x, float y) { return x < y ? 1.0f : 0.0f; });
  case Opcode::Sub:
    return zip(a, b, [](float x, float y) { return x - y; });
  case Opcode::Xpd:
    return cross(a, b);
  case Opcode::Arl:
    return all(std::floor(a[0]));
  case Opcode::Exp:
    return {std::exp2(std::floor(a[0])), fraction(a[0]), std::exp2(a[0]), 1.0f};
  case Opcode::Log:
    return logarithm(a[0]);
  case Opcode::Seq:
    return zip(a, b, [](float x, float y) { return x == y ? 1.0f : 0.0f; });
  case Opcode::Sne:
    return zip(a, b, [](float x, float y) { return x == y ? 0.0f : 1.0f; });
  case Opcode::Ddx:
  case Opcode::Ddy:
    return map(a, [](float x) { return x - x; });
  case Opcode::Pk2h:
  case Opcode::Pk2us:
  case Opcode::Pk4b:
  case Opcode::Pk4ub:
  case Opcode::Up2h:
  case Opcode::Up2us:
  case Opcode::Up4b:
  case Opcode::Up4ub: // handled by applyToBits()
  case Opcode::Tex:
  case Opcode::Txp:
  case Opcode::Txb:
  case Opcode::Txd:
  case Opcode::Txl:
  case Opcode::Kil:
  case Opcode::Rep:
  case Opcode::Endrep:
  case Opcode::Brk:
#define FP_NV_WORD(Enumerator, ...) case Opcode::Enumerator:
#include "fp_compiler/ir/ops.def"
    break;
  }
  assert(false && "not an arithmetic opcode");
  return {};
}
} // namespace

float flushed(float value) {
  return std::fabs(value) < FLT_MIN ? std::copysign(0.0f, value) : value;
}

float saturated(float value) {
  if (!(value > 0.0f))
    return 0.0f;
  return value < 1.0f ? value : 1.0f;
}

Numerics numericsOf(Language language, Numerics asked) {
  const bool vertex = language == Language::ArbVertex;
  return vertex && asked == Numerics::Fp24 ? Numerics::Legacy : ofInstructions(asked);
}

float held(float value, Numerics numerics) {
  return numerics == Numerics::Fp24 ? fp24::rounded(value) : flushed(value);
}

float loaded(float value, Numerics numerics) {
  return numerics == Numerics::Fp24 ? fp24::truncated(value) : flushed(value);
}

bool carriesBits(Opcode op) {
  switch (op) {
  case Opcode::Pk2h:
  case Opcode::Pk2us:
  case Opcode::Pk4b:
  case Opcode::Pk4ub:
  case Opcode::Up2h:
  case Opcode::Up2us:
  case Opcode::Up4b:
  case Opcode::Up4ub:
  case Opcode::Mov:
  case Opcode::Swz:
  case Opcode::Cmp:
    return true;
  default:
    return false;
  }
}

Vec4 applyToBits(Opcode op, const Operands &operands) {
  const Vec4 &a = operands[0];
  switch (op) {
  case Opcode::Pk2h:
    return packed(Packing::Half2, a);
  case Opcode::Pk2us:
    return packed(Packing::Unsigned2, a);
  case Opcode::Pk4b:
    return packed(Packing::Signed4, a);
  case Opcode::Pk4ub:
    return packed(Packing::Unsigned4, a);
  case Opcode::Up2h:
    return map(unpacked(Packing::Half2, a[0]), flushed);
  case Opcode::Up2us:
    return unpacked(Packing::Unsigned2, a[0]);
  case Opcode::Up4b:
    return unpacked(Packing::Signed4, a[0]);
  case Opcode::Up4ub:
    return unpacked(Packing::Unsigned4, a[0]);
  case Opcode::Cmp: {
    Vec4 chosen = operands[2]; // a copy of the vector, because returning a float may change a NaN,
                               // as packed() says
    for (std::size_t i = 0; i < chosen.size(); ++i)
      if (flushed(a[i]) < 0.0f)
        chosen[i] = operands[1][i];
    return chosen;
  }
  default:
    return a;
  }
}

Vec4 apply(Opcode op, const Operands &operands, Numerics numerics, Language language) {
  if (int(op) >= kOpcodeCount && carriesBits(op))
    return applyToBits(op, operands);
  const bool vertex = language == Language::ArbVertex;
  switch (ofInstructions(numerics)) {
  case Numerics::Host:
    return vertex ? Unit<Forwards<Host>>::apply(op, operands) : Unit<Host>::apply(op, operands);
  case Numerics::Legacy:
    return vertex ? Unit<Forwards<Legacy>>::apply(op, operands) : Unit<Legacy>::apply(op, operands);
  case Numerics::Fp24:
    return Unit<Fp24>::apply(op, operands);
  case Numerics::Fx9:
    break; // ofInstructions() replaces this mode
  }
  return {};
}

std::uint32_t iterations(float count) {
  if (!(count >= 1.0f))
    return 0;
  return count < float(kMaxIterations) ? std::uint32_t(count) : kMaxIterations;
}

bool kills(const Vec4 &operand) {
  for (const float value : operand)
    if (flushed(value) < 0.0f)
      return true;
  return false;
}

} // namespace arbiter::fp::ir
