#pragma once
#include <array>

#include "fp_compiler/ir/ir.h"

// clang-format off: the table is one
/// What every opcode means, to the last special value. The specification leaves much undefined;
/// here nothing is, and the interpreter, the folder and every back end follow this page. A back
/// end's host may differ from it by the tolerances that tests/differential states, and nowhere
/// else.
///
/// Numbers. IEEE single precision, round to nearest, each operation rounded by itself (MAD, LRP,
/// dot products: products first, sums from left to right). A denormal, read or produced, counts as
/// zero of its sign. NaN and infinities spread as IEEE says, unless a rule below stops them. NaNs
/// are not told apart.
///
/// Registers. Temporaries, output colours and their components are zero until written. An output
/// depth that was not written is the fragment's own; a vertex result of which nothing is written is
/// as if it were not bound. Address registers start at 0, and a row that is not there is zero. All
/// operands are read before any component is written, so a destination may be a source. Components
/// outside the mask keep their value.
///
/// _SAT     NaN gives 0, then min(max(x, 0), 1).
/// ABS      clears the sign.
/// ADD SUB MUL MAD LRP   as written; LRP is a*b + (1-a)*c.
/// ARL      floor(a), as an integer; beyond +-2^31, or of NaN, an index that no array has.
/// CMP      a < 0 ? b : c; so NaN and -0 choose c.
/// COS SIN  any angle; an infinite one gives NaN.
/// DP3 DP4 DPH           sums from x to w; DPH adds b.w last.
/// DST      (1, a.y*b.y, a.z, b.w)
/// EXP      (2^floor(a), a - floor(a), 2^a, 1)
/// EX2      2^a; overflows to infinity, underflows to 0.
/// FLR FRC  largest integer <= a; a - FLR(a), so FRC of an infinity is NaN.
/// LG2      log2(a); LG2(+-0) is -infinity, so that EX2(n * LG2(0)) is 0 for n > 0; NaN below zero.
/// LOG      of |a|: (floor(log2), |a| / 2^floor(log2), log2, 1); of 0 (-infinity, 1, -infinity, 1).
/// LIT      (1, max(x, 0), x > 0 ? POW(y, e) : 0, 1), e = w clamped to +-(128 - 2^-17).
///          NaN in x gives 0 and 0.
/// MAX MIN  if one operand is NaN, the other one; -0 is below +0.
/// MOV SWZ  copies; SWZ's 0 and 1 take their own sign.
/// POW      a^0 = 1 for every a. A base that is zero, negative or NaN gives 0 for every other
///          exponent, also below zero; else EX2(b * LG2(a)).
/// RCP      1/a; RCP(+-0) is an infinity of the same sign, RCP of an infinity a zero.
/// RSQ      1/sqrt(|a|); RSQ(+-0) is +infinity.
/// SCS      (cos a, sin a, 0, 0) for any angle.
/// SGE SLT  1 or 0; a comparison with NaN is false, so both give 0; -0 equals +0.
/// XPD      (a.yzx*b.zxy - a.zxy*b.yzx, 0)
/// KIL      discards if any component is < 0, so not for NaN and not for -0.
/// TEX      samples at (x, y, z); targets take as many as they have. Shadow targets compare z.
/// TXP      samples at (x/w, y/w, z/w) whatever w's sign; w = 0 samples at an infinity or NaN, and
///          the texel is the wrap mode's choice.
/// TXB      w is added to the level of detail before its clamp; rectangles ignore it.
///
/// Left to the host: LRP with an infinite operand, or with one so large that c + a*(b-c) loses b
/// (hosts compute it so); ABS_SAT of a NaN (0 or 1); a sample at an infinity or NaN.
///
/// Options. ARB_fog_*: each output colour is clamped to [0,1], then its rgb is
/// f*rgb + (1-f)*fog.rgb with f = SAT of 2^(-dc/ln 2), 2^(-(dc)^2/ln 2), or (end-c)/(end-start).
// clang-format on
namespace arbiter::fp::ir {

/// The value that takes part in arithmetic: denormals become zero of the same sign.
[[nodiscard]] float flushed(float value);

/// Clamp to [0,1]; NaN gives 0.
[[nodiscard]] float saturated(float value);

using Operands = std::array<Vec4, 3>;

/// The result of an arithmetic opcode for all four components, before _SAT and mask. Operands are
/// already swizzled and negated; a scalar operand stands in x.
/// Requires: \p op is neither Texture nor Kills.
[[nodiscard]] Vec4 apply(Opcode op, const Operands &operands, Numerics numerics);

/// KIL's condition.
[[nodiscard]] bool kills(const Vec4 &operand);

} // namespace arbiter::fp::ir
