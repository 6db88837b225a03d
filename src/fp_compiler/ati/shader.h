#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "fp_compiler/ir/interface.h"
#include "fp_compiler/span.h"

/// An ATI fragment shader as data: what the text form (ATI_text_fragment_shader, "ATFS") and the
/// API form (ATI_fragment_shader, "AFS") both say. Sections 3.10.1 of ATFS and 3.8.11 of AFS
/// define it; lower.h turns it into IR, evaluate.h runs it as the specification reads. Nothing here
/// checks the rules of the languages: a front end does that while it builds one. Everything is
/// plain data of fixed size.
namespace arbiter::fp::ati {

inline constexpr int kMaxPasses = 2;
inline constexpr int kMaxPairs = 8; ///< instruction pairs of a pass
inline constexpr int kRegisters = 6;
inline constexpr int kConstants = 8;
inline constexpr std::uint8_t kAlpha = 8; ///< in a mask; 1, 2 and 4 are red, green and blue
inline constexpr int kTexCoords = 8;      ///< TEXTURE0..7 of the API form; the text names t0 to t5

/// Table 3.20: which three components a setup takes, and what divides them.
enum class Coordinates : std::uint8_t {
  Str,   ///< (s, t, r)
  Stq,   ///< (s, t, q)
  StrDr, ///< (s/r, t/r, 1/r)
  StqDq, ///< (s/q, t/q, 1/q)
};

/// What fills a register at the start of a pass. All setups of a pass happen at once: each reads
/// what the registers held at the end of the pass before.
enum class SetupKind : std::uint8_t {
  None,         ///< the register is undefined (zero here), whatever the pass before left in it
  PassTexCoord, ///< the three components; the fourth is undefined (zero here)
  SampleMap,    ///< the texture of the image unit with the register's number, sampled there
};

struct Setup {
  SetupKind kind = SetupKind::None;
  bool fromRegister = false; ///< the source is a register of the pass before: second pass only
  std::uint8_t source = 0;   ///< texture coordinate set, 0 to 7; or register, 0 to 5
  Coordinates coordinates = Coordinates::Str;
  Span span; ///< of the statement's text; empty for the API form
};

/// Table 3.21.
enum class Op : std::uint8_t { Mov, Add, Mul, Sub, Dot3, Dot4, Mad, Lerp, Cnd, Cnd0, Dot2Add };

/// 1 for MOV, 2 for ADD to DOT4, 3 for MAD to DOT2ADD.
[[nodiscard]] constexpr int argumentCount(Op op) {
  return op == Op::Mov ? 1 : op <= Op::Dot4 ? 2 : 3;
}

/// DOT3, DOT4 and DOT2ADD: one result for every component.
[[nodiscard]] constexpr bool isDot(Op op) {
  return op == Op::Dot3 || op == Op::Dot4 || op == Op::Dot2Add;
}

/// Table 3.22: what the result is multiplied with, before the clamp of `saturate`.
enum class Scale : std::uint8_t { None, Twice, Four, Eight, Half, Quarter, Eighth };

enum class Source : std::uint8_t {
  Register,  ///< r0 to r5 by index
  Constant,  ///< c0 to c7 by index
  Zero,      ///< "0", ZERO
  One,       ///< "1", ONE
  Primary,   ///< "color0", PRIMARY_COLOR_ARB
  Secondary, ///< "color1", SECONDARY_INTERPOLATOR_ATI; it has no alpha (ATFS:843)
};

/// Table 3.23: None, or one component for all four.
enum class Replicate : std::uint8_t { None, Red, Green, Blue, Alpha };

/// A source argument. The modifiers apply after replication, in the order of the members:
/// -(2 * ((1 - s) - 0.5)) with all of them (ATFS:881, AFS:616).
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
  /// A colour operation: the components written, bit 0 = r to bit 2 = b, never 0 (the API's NONE is
  /// all three). Not looked at for alpha operations, which write a.
  std::uint8_t mask = 7;
  Scale scale = Scale::None;
  bool saturate = false;
  std::array<Argument, 3> arguments; ///< argumentCount(op) of them
  bool operator==(const Operation &) const = default;
};

/// A colour and an alpha operation that execute in parallel: both read the registers as they were
/// before the pair (ATFS:542, AFS:422). Either may be missing.
struct Pair {
  std::optional<Operation> color;
  /// The arguments of a dot product here are ignored: its result is that of the colour operation's,
  /// under this operation's own destination modifiers (AFS:496). There is a colour operation with
  /// the same opcode then.
  std::optional<Operation> alpha;
  Span span; ///< of the first statement's text; empty for the API form
};

struct Pass {
  std::array<Setup, kRegisters> setups; ///< element i fills register i
  std::array<Pair, kMaxPairs> pairs;    ///< pairCount of them, in order
  std::uint8_t pairCount = 0;
};

enum class ConstantKind : std::uint8_t {
  Value, ///< a literal; or set between Begin and EndFragmentShaderATI (AFS:632)
  Env,   ///< program.env[index]; of the API form, the global CON_index_ATI
  Local, ///< program.local[index]
};

/// One of c0 to c7. Components outside [0,1] are undefined by the specification; here they are
/// clamped to it where the shader reads them, and queries return them as they were given.
struct Constant {
  ConstantKind kind = ConstantKind::Env;
  std::uint8_t index = 0; ///< Env, Local
  ir::Vec4 value = {};    ///< Value
};

/// A shader. r0 at the end of the last pass is the fragment's colour; zero if there is no pass.
struct Shader {
  std::array<Pass, kMaxPasses> passes; ///< passCount of them
  std::uint8_t passCount = 0;
  std::array<Constant, kConstants> constants; ///< initially each the API's global constant

  Shader() {
    for (std::size_t i = 0; i < constants.size(); ++i)
      constants[i].index = std::uint8_t(i);
  }
};

} // namespace arbiter::fp::ati
