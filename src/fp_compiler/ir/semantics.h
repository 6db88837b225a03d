#pragma once
#include <array>

#include "fp_compiler/ir/ir.h"

// The table below has its own layout.
// clang-format off
/// The result of every opcode, for every special value. The specification leaves much undefined;
/// here everything is defined. The interpreter, constant folding and every back end follow this
/// page. A back end may differ only by the tolerances of tests/back_ends_vs_interpreter.
///
/// Numbers. IEEE single precision, round to nearest, each operation rounded separately (MAD, LRP,
/// dot products: products first, then their sums). A denormal that is read or produced is a zero of
/// its sign. NaN and infinities propagate as in IEEE, unless a rule below stops them. All NaNs are
/// equivalent.
///
/// Registers. Temporaries, output colours and their components are zero until written. An output
/// depth that was not written is the fragment's own. A vertex result without any written component
/// counts as not bound. Address registers start at 0, and a row that does not exist is zero. All
/// operands are read before any component is written, so a destination may be a source. Components
/// outside the mask keep their value.
///
/// _SAT     NaN gives 0, then min(max(x, 0), 1).
/// ABS      clears the sign.
/// ADD SUB MUL MAD LRP   as written; LRP is a*b + (1-a)*c.
/// ARL      floor(a), as an integer; beyond +-2^31, or for NaN, an index that no array has.
/// CMP      a < 0 ? b : c, so NaN and -0 select c.
/// COS SIN  any angle; an infinite one gives NaN.
/// DP3 DP4  in fragment programs ((w + z) + y) + x: the last two products are added first. In
///          vertex programs ((x + y) + z) + w: the first two are added first.
/// DPH      in fragment programs (x + (z + b.w)) + y, in vertex programs ((x + y) + z) + b.w.
///          The orders of fragment programs are those of llvmpipe for programs of its own parser.
///          The orders of vertex programs are those of MUL and three MADs on the same rows, as
///          hosts transform in fixed function. So DP4, DPH, MUL and MAD, and fixed function give
///          positions with the same bits, and passes that mix them meet at equal depths.
/// DST      (1, a.y*b.y, a.z, b.w)
/// EXP      (2^floor(a), a - floor(a), 2^a, 1)
/// EX2      2^a; overflows to infinity, underflows to 0.
/// FLR FRC  largest integer <= a; a - FLR(a), so FRC of an infinity is NaN.
/// LG2      log2(a); NaN below zero. LG2(+-0) is -infinity, so that EX2(n * LG2(0)) is 0 for n > 0.
/// LOG      (floor(log2), |a| / 2^floor(log2), log2, 1) of |a|; (-infinity, 1, -infinity, 1) of 0.
/// LIT      (1, max(x, 0), x > 0 ? POW(y, e) : 0, 1), e = w clamped to +-(128 - 2^-17).
///          NaN in x gives 0 and 0.
/// MAX MIN  if one operand is NaN, the other operand; -0 is below +0.
/// MOV SWZ  copies; the constants 0 and 1 of SWZ take the component's sign.
/// POW      a^0 = 1 for every a. For any other exponent, also below zero, a base that is zero,
///          negative or NaN gives 0; otherwise EX2(b * LG2(a)).
/// RCP      1/a; RCP(+-0) is an infinity of the same sign, RCP of an infinity a zero.
/// RSQ      1/sqrt(|a|); RSQ(+-0) is +infinity.
/// SCS      (cos a, sin a, 0, 0) for any angle.
/// SGE SLT  1 or 0; a comparison with NaN is false, so both give 0; -0 equals +0.
/// SEQ SNE  1 or 0; a comparison with NaN makes SEQ 0 and SNE 1; -0 equals +0.
/// DDX DDY  the difference within the fragment's 2x2 pixels of the window: right minus left, and
///          upper minus lower. For a single fragment 0, or NaN if a - a is NaN. A fragment counts
///          as single while one of the other three has left a loop that it is in.
/// PK* UP*  as in ir/packing.h: their floats are bits. In programs under NVIDIA's options MOV, SWZ
///          and CMP carry bits too, denormals included; every other opcode flushes denormals.
/// XPD      (a.yzx*b.zxy - a.zxy*b.yzx, 0)
/// KIL      discards if any component is < 0, so not for NaN and not for -0.
/// REP      runs its body, up to ENDREP, floor(operand) times; NaN and values below 1 give 0 times.
///          Once a program's loops have begun 65,000 iterations, no further iteration begins. BRK
///          leaves the innermost loop if its operand is not 0.
/// TEX      samples at (x, y, z), as many as the target has. Shadow targets compare z.
/// TXP      samples at (x/w, y/w, z/w), whatever w's sign. If w = 0 it samples at an infinity or
///          NaN, and the wrap mode decides the texel.
/// TXD      the second and third operand are the derivatives that give the level of detail.
/// TXL      the level of detail is w, then clamped.
/// TXB      w is added to the level of detail before its clamp; rectangles ignore it.
///
/// The host decides these: LRP with an infinite operand, or with one so large that c + a*(b-c)
/// loses b (hosts compute it so); x - x of an infinity or a NaN (hosts give 0, as GLSL need not
/// support NaN); ABS_SAT of a NaN (0 or 1); a sample at an infinity or NaN.
///
/// Options. Colour sum: the rgb of each output colour is clamped to [0,1], then ADD of the secondary
/// colour. ARB_fog_*: each output colour is clamped to [0,1], then its rgb is f*rgb + (1-f)*fog.rgb,
/// as LRP, with the factor f of ir/fog.h. Its instructions are MUL EX2, MUL MUL EX2 or MAD.
///
/// All of this is Numerics::Host. The other modes differ from it only as follows:
///
/// Legacy   A product of a zero and an infinity or a NaN is +0. A denormal factor counts as a zero.
///          The rule holds for each single product of MUL MAD DP3 DP4 DPH LRP XPD DST, for POW's
///          b * LG2(a), so that POW(1, b) is 1 for every b, and for the fog option's. Every other
///          product is that of Host, including the sign of a zero. So the two modes differ only
///          where Host gives a NaN. (Later chips make every product with a zero +0. For the chips
///          of the time only the zero is known, not its sign. This choice keeps x*1 the same as x,
///          and lets a back end write a plain product if it knows that the factors are finite.)
///
/// Fp24     For fragment programs; a vertex program uses Legacy (numericsOf). Legacy's rule holds,
///          and every value is a 24-bit float (fp_compiler/numerics.h) stored in a single.
///   Reads     Attributes are fp24::rounded; all components of both colours are fp24::colour;
///             constants, env, local and state rows are fp24::truncated.
///   Steps     Each single operation runs on singles as above, and its result is fp24::rounded:
///             each product, each sum (also inside MAD, LRP, XPD and the dot products,
///             ((x + y) + z) + w), 1-a of LRP, a - FLR(a). Rounding twice is part of the
///             definition. If the single result is a tie of the 24-bit grid only because it was
///             rounded, a single rounding would differ by one unit in the last place.
///   Functions COS EX2 LG2 RCP RSQ SCS SIN: the exact result rounded to a single, then
///             fp24::rounded. POW is three steps, LG2 MUL EX2, and LIT's POW is too. The limit
///             of LIT's exponent is a constant, so it is truncated: +-(128 - 2^-10). A host that
///             is off by one unit of a single is off by one unit of 24 bits in about one such
///             result of 128, else exact.
///   Exact     ABS CMP FLR MAX MIN MOV SGE SLT SWZ KIL, signs and _SAT need no rounding.
///   Textures  Texels are fp24::rounded. The texture unit does TXP's division and TXB's bias: in
///             singles, from 24-bit coordinates, without rounding to 24 bits.
///   Options   The fog coordinate and the secondary colour are read as attributes. The row of ir/fog.h
///             is one that a driver loads: computed in singles from the state without rounding, then
///             truncated.
///   Outputs   are stored without conversion; a depth that is not written is the fragment's own.
// clang-format on
namespace arbiter::fp::ir {

/// Returns the value that arithmetic uses: denormals become zero of the same sign.
[[nodiscard]] float flushed(float value);

/// Returns the mode that a program of \p language follows if \p asked is set.
[[nodiscard]] Numerics numericsOf(Language language, Numerics asked);

/// Returns a result, a texel, or an attribute that is not a colour, as a register holds it:
/// flushed, and in Fp24 rounded.
[[nodiscard]] float held(float value, Numerics numerics);
/// Returns a constant or a row of parameters as an instruction reads it: in Fp24 truncated.
[[nodiscard]] float loaded(float value, Numerics numerics);

/// Clamps to [0,1]; NaN gives 0.
[[nodiscard]] float saturated(float value);

using Operands = std::array<Vec4, 3>;

/// Returns the result of an arithmetic opcode for all four components, before _SAT and mask. The
/// operands are already swizzled and negated; a scalar operand is in x.
/// Requires: \p op is neither Texture nor Kills; in Fp24 the operands are 24-bit floats.
/// \param language the program's: vertex programs add in another order
[[nodiscard]] Vec4 apply(Opcode op, const Operands &operands, Numerics numerics,
                         Language language = Language::ArbFragment);

/// True for the opcodes that copy bits or make them; see PK* above.
[[nodiscard]] bool carriesBits(Opcode op);
/// Returns the result of such an opcode, without flushing denormals.
/// Requires: carriesBits(op).
[[nodiscard]] Vec4 applyToBits(Opcode op, const Operands &operands);

/// The most iterations that a run of a program begins, over all its loops. This is enough for the
/// 65,536 instructions that NV_fragment_program2 promises, and below the 65,535 after which
/// llvmpipe ends a loop by itself.
inline constexpr std::uint32_t kMaxIterations = 65000;
/// Returns how often REP runs its body.
[[nodiscard]] std::uint32_t iterations(float count);

/// True if KIL discards.
[[nodiscard]] bool kills(const Vec4 &operand);

} // namespace arbiter::fp::ir
