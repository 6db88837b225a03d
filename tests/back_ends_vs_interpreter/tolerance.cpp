#include "tolerance.h"

#include <cmath>

namespace arbiter::differential {

using fp::ir::Opcode;

namespace {
constexpr float kHalfUlp = 0x1p-23f;
constexpr Tolerance kExact = {};
/// Hosts may fuse a product and a sum, and change the order of sums.
constexpr Tolerance kArithmetic = {kHalfUlp, kHalfUlp, 0};
constexpr Tolerance kReciprocal = {0, 0x1p-21f, 0};
/// These allow for polynomials of 2^x and log2 x: a software host's are good to about 2^-19.
constexpr Tolerance kExponential = {kHalfUlp, 0x1p-18f, 0};
constexpr Tolerance kLogarithm = {kHalfUlp, 0x1p-18f, 0x1p-18f};
constexpr Tolerance kPower = {kHalfUlp, 0x1p-15f, 0x1p-20f};
constexpr Tolerance kTrigonometric = {0x1p-22f, 0, 0x1p-18f};
/// Hosts convert texel coordinates to fixed point.
constexpr Tolerance kSampled = {0x1p-16f, 0, 0};

/// If the exact result is near the middle of two 24-bit numbers, the least error of a single rounds
/// it to the other. That is one unit of 24 bits, which a relative 2^-16 covers for any mantissa.
constexpr float kUnit24 = 0x1p-16f;
/// POW is three steps in 24 bits: the last bit of the logarithm has this effect on a power of 2^16.
constexpr Tolerance kPower24 = {0, 0x1p-12f, 0};

Tolerance tolerance24(Opcode op) {
  switch (op) {
  case Opcode::Rcp:
  case Opcode::Rsq:
  case Opcode::Ex2:
    return {0, kUnit24, 0};
  case Opcode::Lg2:
    return {0, kUnit24, kLogarithm.absolute};
  case Opcode::Lit:
  case Opcode::Pow:
    return kPower24;
  case Opcode::Cos:
  case Opcode::Sin:
  case Opcode::Scs:
    return {0, kUnit24, 0x1p-17f};
  case Opcode::Tex:
  case Opcode::Txp:
  case Opcode::Txb:
    return kSampled;
  default:
    return kExact;
  }
}
} // namespace

Tolerance tolerance(Opcode op, fp::Numerics numerics) {
  if (numerics == fp::Numerics::Fp24)
    return tolerance24(op);
  switch (op) {
  case Opcode::Add:
  case Opcode::Dp3:
  case Opcode::Dp4:
  case Opcode::Dph:
  case Opcode::Dst:
  case Opcode::Lrp:
  case Opcode::Mad:
  case Opcode::Mul:
  case Opcode::Sub:
  case Opcode::Xpd:
  case Opcode::Frc:
  case Opcode::Ddx:
  case Opcode::Ddy:
    return kArithmetic;
  case Opcode::Rcp:
  case Opcode::Rsq:
    return kReciprocal;
  case Opcode::Ex2:
  case Opcode::Exp:
    return kExponential;
  case Opcode::Lg2:
  case Opcode::Log:
    return kLogarithm;
  case Opcode::Lit:
  case Opcode::Pow:
    return kPower;
  case Opcode::Cos:
  case Opcode::Sin:
  case Opcode::Scs:
    return kTrigonometric;
  case Opcode::Tex:
  case Opcode::Txp:
  case Opcode::Txb:
  case Opcode::Txd:
  case Opcode::Txl:
    return kSampled;
  case Opcode::Up2us:
  case Opcode::Up4b:
  case Opcode::Up4ub:
    return kReciprocal; // hosts may multiply by the reciprocal
  case Opcode::Abs:
  case Opcode::Arl:
  case Opcode::Cmp:
  case Opcode::Flr:
  case Opcode::Max:
  case Opcode::Min:
  case Opcode::Mov:
  case Opcode::Sge:
  case Opcode::Slt:
  case Opcode::Swz:
  case Opcode::Kil:
    return kExact;
  default: // comparisons, packing, loops
    return kExact;
  }
}

bool sumsProducts(Opcode op) {
  const Tolerance allowed = tolerance(op, fp::Numerics::Host);
  return allowed.operand == kArithmetic.operand && allowed.relative == kArithmetic.relative &&
         allowed.absolute == 0;
}

} // namespace arbiter::differential
