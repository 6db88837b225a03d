#pragma once
#include <optional>
#include <string>
#include <vector>

#include "apps/tools/ir_names.h"
#include "fp_compiler/diagnostic.h"
#include "fp_compiler/ir/evaluate.h"

/// Records a program's execution for one pixel or vertex as plain data, with one row per
/// instruction. Programs have no branches, so that one trace holds every step, and stepping in
/// either direction changes the row.
namespace arbiter::tools::debug {

/// Values of two arithmetics: the one that the program runs with, and one to compare.
template <typename Value> struct Both {
  Value first = {};
  Value second = {};
};

/// One operand of a row.
struct Operand {
  fp::Span span;
  std::string text; ///< as written in the program: "-offset.yxzw"
  Both<Vec4> value; ///< as read, with swizzle and sign
  File file = File::Temporary;
  unsigned reg = 0;       ///< index of the register in its file; with relative addressing, of the
                          ///< array
  std::uint8_t reads = 0; ///< components of `value` that the instruction uses
  std::uint8_t unwritten = 0; ///< those never written before, which are zero
};

/// A texture access: its coordinate and its result.
struct Texel {
  unsigned unit = 0;
  fp::ir::TexTarget target = fp::ir::TexTarget::Tex2D;
  Both<Vec4> coordinate;    ///< after TXP's division
  Both<float> bias;         ///< for TXB
  Both<Vec4> value;         ///< before the write mask
  std::optional<float> lod; ///< in the first arithmetic; empty if the image's size is unknown
};

/// Bits of Row::flags, which mark rows worth inspecting.
enum Flag : unsigned {
  kNan = 1,
  kInf = 2,
  kOver1 = 4,     ///< a written component is above 1
  kBelow0 = 8,    ///< a written component is below 0
  kUnwritten = 16 ///< an operand's component is read that was never written
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
  std::string text; ///< the statement, on one line
  Opcode op = Opcode::Mov;
  std::vector<Operand> operands;
  std::string destination; ///< as written in the program: "offset.xy"; empty for KIL
  /// The register's name: the destination of the register's first row, without mask. Aliases are
  /// the same register.
  std::string name;
  File file = File::Temporary;
  unsigned reg = 0;
  std::uint8_t mask = 0; ///< written components; 0 for KIL
  Both<Vec4> value;      ///< the whole register after the write
  Vec4 error = {};       ///< second - first for written components; 0 if both are NaN
  std::optional<Texel> texel;
  Both<bool> discards;      ///< KIL's condition was true
  bool isDiscarded = false; ///< an earlier KIL discarded the fragment (first arithmetic)
  unsigned flags = 0;       ///< in the first arithmetic
};

/// A named vector: an input or a result of the program.
struct Named {
  std::string name; ///< "fragment.texcoord[0]", "program.local[1]", "result.color"
  Both<Vec4> value;
  std::uint8_t mask = 0xF; ///< for results: the components that are written
};

struct Trace {
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  Both<fp::Numerics> numerics;
  std::vector<Named> attributes;
  std::vector<Named> parameters; ///< without constants
  std::vector<Row> rows;
  std::vector<Named> results; ///< after fog and color sum; unclamped without them
  Both<bool> isDiscarded;
};

/// Returns the greatest absolute error of the written components; infinite if exactly one of the
/// two values is a number.
[[nodiscard]] float greatestError(const Row &row);

/// Returns the last row at or before \p line, or else the first row. Requires: there are rows.
[[nodiscard]] std::size_t rowAtLine(const Trace &trace, std::uint32_t line);

} // namespace arbiter::tools::debug
