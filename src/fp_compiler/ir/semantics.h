#pragma once
#include <array>

#include "fp_compiler/ir/ir.h"

// clang-format off: the table is one
/// What every opcode means, to the last special value. The specification leaves much undefined;
/// here nothing is, and the interpreter, the folder and every back end follow this page. A back
/// end's host may differ from it by the tolerances that tests/back_ends_vs_interpreter states, and
/// nowhere else.
///
/// Numbers. IEEE single precision, round to nearest, each operation rounded by itself (MAD, LRP,
/// dot products: products first, then their sums). A denormal, read or produced, counts as
/// zero of its sign. NaN and infinities spread as IEEE says, unless a rule below stops them. NaNs
/// are all the same.
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
/// DP3 DP4  of fragment programs: the last two products are added first, then towards x:
///          ((w + z) + y) + x. Of vertex programs from the first one on: ((x + y) + z) + w.
/// DPH      of fragment programs (x + (z + b.w)) + y, of vertex programs ((x + y) + z) + b.w.
///          The orders of fragment programs are llvmpipe's, for its own parser's programs. Those of
///          vertex programs are what MUL and three MADs make of the same rows, as hosts transform
///          in fixed function: so positions by DP4, by DPH, by MUL and MAD and of fixed function
///          are the same bits, and passes meet at equal depths whichever of them they use.
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
/// SEQ SNE  1 or 0; a comparison with NaN makes SEQ 0 and SNE 1; -0 equals +0.
/// DDX DDY  the difference within the 2x2 pixels of the window that the fragment is of, right less
///          left and upper less lower. Of a fragment alone 0, or NaN where a - a is; it is
///          alone while one of the other three has left a loop that it is in.
/// PK* UP*  of ir/packing.h: their floats are bits. In programs under NVIDIA's options MOV, SWZ and
///          CMP carry bits too, denormals included; every other opcode flushes them.
/// XPD      (a.yzx*b.zxy - a.zxy*b.yzx, 0)
/// KIL      discards if any component is < 0, so not for NaN and not for -0.
/// REP      runs what stands before its ENDREP as often as the operand's floor says; NaN and what
/// is
///          below 1 are 0 times. When a program's loops have begun 65,000 iterations, none begins
///          any more. BRK leaves the innermost loop where its operand is not 0.
/// TEX      samples at (x, y, z); targets take as many as they have. Shadow targets compare z.
/// TXP      samples at (x/w, y/w, z/w) whatever w's sign; w = 0 samples at an infinity or NaN, and
///          the texel is the wrap mode's choice.
/// TXD      the level of detail is that of the derivatives in the second and third operand.
/// TXL      the level of detail is w, then clamped.
/// TXB      w is added to the level of detail before its clamp; rectangles ignore it.
///
/// Left to the host: LRP with an infinite operand, or with one so large that c + a*(b-c) loses b
/// (hosts compute it so); x - x of an infinity or a NaN (they make 0 of it, as GLSL owes no
/// NaN); ABS_SAT of a NaN (0 or 1); a sample at an infinity or NaN.
///
/// Options. ARB_fog_*: each output colour is clamped to [0,1], then its rgb is
/// f*rgb + (1-f)*fog.rgb, as LRP, with f = SAT of 2^(-dc/ln 2), 2^(-(dc)^2/ln 2), or
/// (end-c)/(end-start).
///
/// All of the above is Numerics::Host; the other modes change this much of it and no more:
///
/// Legacy   A product of a zero and an infinity or a NaN is +0. A factor that is a denormal is a
///          zero. It holds for each single product of MUL MAD DP3 DP4 DPH LRP XPD DST, for POW's
///          b * LG2(a), so that POW(1, b) is 1 for every b, and for the fog option's. Every other
///          product is Host's, the sign of a zero included: so the two modes differ where Host
///          makes a NaN, and only there. (Chips that came later make +0 of every product with a
///          zero; of the era's own it is not known, only that it is a zero. This choice keeps x*1
///          the same as x, and lets a back end write a plain product where it knows that the
///          factors are finite.)
///
/// Fp24     Of fragment programs; a vertex program follows Legacy (numericsOf). Legacy's rule, and
///          every value is a 24-bit float (fp_compiler/numerics.h) held in a single.
///   Reads     Attributes are fp24::rounded, both colours fp24::colour in all components;
///             constants, env, local and state rows are fp24::truncated.
///   Steps     Each single operation is done on singles as above, and its result is
///             fp24::rounded: each product, each sum (also those inside of MAD, LRP, XPD and the
///             dot products, ((x + y) + z) + w), 1-a of LRP, a - FLR(a). That it is rounded twice
///             is the definition. Where the single result is a tie of the 24-bit grid only because
///             of its own rounding, one rounding would differ by a unit of the last place.
///   Functions COS EX2 LG2 RCP RSQ SCS SIN: the exact result to a single, then fp24::rounded.
///             POW is three steps, LG2 MUL EX2; LIT's POW is that, and its exponent's limit, a
///             constant, is truncated: +-(128 - 2^-10). A host that is a unit of a single off is a
///             unit of the 24 bits off in about one such result of 128, and right in the others.
///   Exact     ABS CMP FLR MAX MIN MOV SGE SLT SWZ KIL, signs and _SAT: they need no rounding.
///   Textures  Texels are fp24::rounded. TXP's division and TXB's bias are the texture unit's own:
///             in singles, of 24-bit coordinates, not rounded.
///   Options   Fog is what the specification charges for it: MUL EX2, MUL MUL EX2 or MAD, and LRP.
///             exp     f = EX2(-MUL(c, p)), p = d * 1.442695041 (1 / ln 2)
///             exp2    f = EX2(-MUL(t, t)), t = MUL(c, p), p = d * 1.201122409 (1 / sqrt(ln 2))
///             linear  f = MAD(c, -s, p), s = fog.params.w, p = end * s
///             c is read as an attribute; p and s are rows that a driver loads: made in singles of
///             the state as it is, then truncated. Colour sum: ADD of the secondary colour, read as
///             that attribute.
///   Outputs   are stored as they are; a depth that is not written stays the fragment's own.
// clang-format on
namespace arbiter::fp::ir {

/// The value that takes part in arithmetic: denormals become zero of the same sign.
[[nodiscard]] float flushed(float value);

/// The mode that a program of \p language follows when \p asked is set.
[[nodiscard]] Numerics numericsOf(Language language, Numerics asked);

/// A result, a texel, or an attribute that is no colour, as a register holds it: flushed, and in
/// Fp24 rounded.
[[nodiscard]] float held(float value, Numerics numerics);
/// A constant or a row of parameters, as an instruction reads it: in Fp24 truncated.
[[nodiscard]] float loaded(float value, Numerics numerics);

/// Clamp to [0,1]; NaN gives 0.
[[nodiscard]] float saturated(float value);

using Operands = std::array<Vec4, 3>;

/// The result of an arithmetic opcode for all four components, before _SAT and mask. Operands are
/// already swizzled and negated; a scalar operand stands in x.
/// Requires: \p op is neither Texture nor Kills; in Fp24 the operands are 24-bit floats.
/// \param language the program's: of vertex programs the order of sums is another
[[nodiscard]] Vec4 apply(Opcode op, const Operands &operands, Numerics numerics,
                         Language language = Language::ArbFragment);

/// True for the opcodes that move bits or make them; see PK* above.
[[nodiscard]] bool carriesBits(Opcode op);
/// What such an opcode makes, without a flush. Requires carriesBits(op).
[[nodiscard]] Vec4 applyToBits(Opcode op, const Operands &operands);

/// Iterations that a run of a program begins at most, of all its loops together: enough for the
/// 65,536 instructions that NV_fragment_program2 promises, and fewer than the 65,535 after which
/// llvmpipe ends a loop by itself.
inline constexpr std::uint32_t kMostIterations = 65000;
/// REP's.
[[nodiscard]] std::uint32_t iterations(float count);

/// KIL's condition.
[[nodiscard]] bool kills(const Vec4 &operand);

} // namespace arbiter::fp::ir
