#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fp_compiler/diagnostic.h"
#include "fp_compiler/ir/evaluate.h"

/// What a program did for one pixel (or one vertex), a row an instruction: plain data. A program is
/// a straight line, so one trace holds every step, and stepping either way is moving a row.
namespace arbiter::tools::debug {

using fp::ir::Vec4;

/// Two arithmetics side by side: what the program is run with, and what it is compared with.
template <typename Value> struct Both {
  Value first = {};
  Value second = {};
};

/// One operand of a row.
struct Operand {
  fp::Span span;
  std::string text; ///< as it stands in the program: "-offset.yxzw"
  Both<Vec4> value; ///< as read: swizzled and signed
  fp::ir::File file = fp::ir::File::Temporary;
  unsigned reg = 0;       ///< Index of the register in its file; of an array where it is relative
  std::uint8_t reads = 0; ///< components of `value` that the instruction takes
  std::uint8_t unwritten = 0; ///< those of them that nothing has written: they are zero
};

/// What a texture access asked for, and got.
struct Texel {
  unsigned unit = 0;
  fp::ir::TexTarget target = fp::ir::TexTarget::Tex2D;
  Both<Vec4> coordinate;    ///< TXP has divided
  Both<float> bias;         ///< TXB's
  Both<Vec4> value;         ///< before the write mask
  std::optional<float> lod; ///< of the first; none where the size of the image is not known
};

/// What a reader wants to be shown. Bits of Row::flags.
enum Flag : unsigned {
  kNan = 1,
  kInf = 2,
  kOver1 = 4,     ///< a written component is above 1
  kBelow0 = 8,    ///< .. below 0
  kUnwritten = 16 ///< an operand's component that nothing has written is read
};
struct FlagName {
  Flag flag;
  const char *name; ///< "nan"
};
inline constexpr FlagName kFlagNames[] = {{kNan, "nan"},
                                          {kInf, "inf"},
                                          {kOver1, "over1"},
                                          {kBelow0, "below0"},
                                          {kUnwritten, "unwritten"}};

/// One instruction.
struct Row {
  fp::Span span;
  fp::LineColumn at;
  std::string text; ///< the statement on one line
  fp::ir::Opcode op = fp::ir::Opcode::Mov;
  std::vector<Operand> operands;
  std::string destination; ///< as it stands in the program: "offset.xy"; empty of KIL
  /// The register's name: the destination without its mask, as the register's first row has it. An
  /// alias is the same register.
  std::string name;
  fp::ir::File file = fp::ir::File::Temporary;
  unsigned reg = 0;
  std::uint8_t mask = 0; ///< components written; 0 of KIL
  Both<Vec4> value;      ///< the whole register after the write
  Vec4 error = {};       ///< second - first of the components written; 0 where both are NaN
  std::optional<Texel> texel;
  Both<bool> discards;      ///< KIL's condition held
  bool isDiscarded = false; ///< an earlier KIL has discarded the fragment (of the first)
  unsigned flags = 0;       ///< of the first arithmetic
};

/// A named vec4 that the program was given or has made.
struct Named {
  std::string name; ///< "fragment.texcoord[0]", "program.local[1]", "result.color"
  Both<Vec4> value;
  std::uint8_t mask = 0xF; ///< of results: the components that something writes
};

struct Trace {
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  Both<fp::Numerics> numerics;
  std::vector<Named> attributes;
  std::vector<Named> parameters; ///< without constants
  std::vector<Row> rows;
  std::vector<Named> results; ///< with fog and colour sum; not clamped without
  Both<bool> isDiscarded;
};

/// The greatest error of the components written, without sign; infinite where only one of the two
/// is a number.
[[nodiscard]] float greatestError(const Row &row);

/// The last row at or before \p line, or the first one if there is none. Requires: there are rows.
[[nodiscard]] std::size_t rowAtLine(const Trace &trace, std::uint32_t line);

} // namespace arbiter::tools::debug
