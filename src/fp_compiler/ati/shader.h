#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "fp_compiler/ir/interface.h"
#include "fp_compiler/span.h"

/// An ATI fragment shader as data, in the text form (ATI_text_fragment_shader, "ATFS") or the API
/// form (ATI_fragment_shader, "AFS"). Sections 3.10.1 of ATFS and 3.8.11 of AFS define it. lower.h
/// turns it into IR, and evaluate.h executes it by the letter of the specification. Nothing here
/// checks the rules of the languages; a front end does that while it builds a shader. All types are
/// plain data of fixed size.
namespace arbiter::fp::ati {

inline constexpr int kMaxPasses = 2;
inline constexpr int kMaxPairs = 8; ///< instruction pairs of a pass
inline constexpr int kRegisters = 6;
inline constexpr int kConstants = 8;
inline constexpr std::uint8_t kAlpha = 8; ///< mask bit; 1, 2 and 4 are red, green and blue
inline constexpr int kTexCoords = 8;      ///< TEXTURE0..7 of the API form; the text names t0 to t5

/// The three components that a setup takes, and their divisor (table 3.20).
enum class Coordinates : std::uint8_t {
  Str,   ///< (s, t, r)
  Stq,   ///< (s, t, q)
  StrDr, ///< (s/r, t/r, 1/r)
  StqDq, ///< (s/q, t/q, 1/q)
};

/// The operation that fills a register at the start of a pass. All setups of a pass happen at once:
/// each reads the registers as they were at the end of the previous pass.
enum class SetupKind : std::uint8_t {
  None,         ///< the register is undefined (zero here), even if the previous pass wrote it
  PassTexCoord, ///< takes three components; the fourth is undefined (zero here)
  SampleMap,    ///< samples the texture of the image unit with the register's number
};

struct Setup {
  SetupKind kind = SetupKind::None;
  bool fromRegister = false; ///< the source is a register of the previous pass: second pass only
  std::uint8_t source = 0;   ///< texture coordinate set, 0 to 7; or register, 0 to 5
  Coordinates coordinates = Coordinates::Str;
  Span span; ///< text of the statement; empty for the API form
};

/// Opcodes (table 3.21).
enum class Op : std::uint8_t { Mov, Add, Mul, Sub, Dot3, Dot4, Mad, Lerp, Cnd, Cnd0, Dot2Add };

/// Returns the number of arguments: 1 for MOV, 2 for ADD to DOT4, 3 for MAD to DOT2ADD.
[[nodiscard]] constexpr int argumentCount(Op op) {
  return op == Op::Mov ? 1 : op <= Op::Dot4 ? 2 : 3;
}

/// True for DOT3, DOT4 and DOT2ADD, whose result is the same in every component.
[[nodiscard]] constexpr bool isDot(Op op) {
  return op == Op::Dot3 || op == Op::Dot4 || op == Op::Dot2Add;
}

/// The factor of the result, applied before the clamp of `saturate` (table 3.22).
enum class Scale : std::uint8_t { None, Twice, Four, Eight, Half, Quarter, Eighth };

enum class Source : std::uint8_t {
  Register,  ///< r0 to r5 by index
  Constant,  ///< c0 to c7 by index
  Zero,      ///< "0", ZERO
  One,       ///< "1", ONE
  Primary,   ///< "color0", PRIMARY_COLOR_ARB
  Secondary, ///< "color1", SECONDARY_INTERPOLATOR_ATI; it has no alpha (ATFS:843)
};

/// None, or one component for all four (table 3.23).
enum class Replicate : std::uint8_t { None, Red, Green, Blue, Alpha };

/// A source argument. The modifiers apply after replication, in the order of the members: -(2 * ((1
/// - s) - 0.5)) with all of them (ATFS:881, AFS:616).
struct Argument {
  Source source = Source::Zero;
  std::uint8_t index = 0; ///< Register, Constant
  Replicate replicate = Replicate::None;
  bool complement = false; ///< comp
  bool bias = false;
  bool twice = false;  ///< 2x
  bool negate = false; ///< neg
  bool operator==(const Argument &) const = default;
};

/// One half of an instruction pair.
struct Operation {
  Op op = Op::Mov;
  std::uint8_t destination = 0; ///< register 0 to 5
  /// The components that a colour operation writes: bit 0 = r to bit 2 = b, never 0 (the API's NONE
  /// means all three). Alpha operations ignore it and write a.
  std::uint8_t mask = 7;
  Scale scale = Scale::None;
  bool saturate = false;
  std::array<Argument, 3> arguments; ///< argumentCount(op) arguments
  bool operator==(const Operation &) const = default;
};

/// A colour and an alpha operation that execute in parallel. Both read the registers as they were
/// before the pair (ATFS:542, AFS:422). Either may be missing.
struct Pair {
  std::optional<Operation> color;
  /// The alpha operation. A dot product here ignores its arguments and takes the result of the
  /// colour operation, which has the same opcode. It applies its own destination modifiers
  /// (AFS:496).
  std::optional<Operation> alpha;
  Span span; ///< text of the first statement; empty for the API form
};

struct Pass {
  std::array<Setup, kRegisters> setups; ///< element i fills register i
  std::array<Pair, kMaxPairs> pairs;    ///< pairCount pairs, in order
  std::uint8_t pairCount = 0;
};

enum class ConstantKind : std::uint8_t {
  Value, ///< a literal; or set between Begin and EndFragmentShaderATI (AFS:632)
  Env,   ///< program.env[index]; in the API form, the global CON_index_ATI
  Local, ///< program.local[index]
};

/// One of c0 to c7. The specification leaves components outside [0,1] undefined. Here they are
/// clamped where the shader reads them, and queries return the original values.
struct Constant {
  ConstantKind kind = ConstantKind::Env;
  std::uint8_t index = 0; ///< Env, Local
  ir::Vec4 value = {};    ///< Value
};

/// A shader. The fragment's colour is r0 after the last pass, or zero if there is no pass.
struct Shader {
  std::array<Pass, kMaxPasses> passes; ///< passCount passes
  std::uint8_t passCount = 0;
  std::array<Constant, kConstants> constants; ///< initially the API's global constants

  Shader() {
    for (std::size_t i = 0; i < constants.size(); ++i)
      constants[i].index = std::uint8_t(i);
  }
};

} // namespace arbiter::fp::ati
