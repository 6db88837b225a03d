#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/front/token.h"
#include "fp_compiler/ir/ir.h"

/// The parts of a statement, which commas divide, as messages and hints name them.
namespace arbiter::fp {

enum class PartKind : std::uint8_t { Destination, Operand, Selector, Unit, Target };

/// \p number counts operands and selectors from 0.
struct Part {
  PartKind kind;
  int number = 0;
};

/// "first" to "fourth", from 0.
[[nodiscard]] const char *ordinal(int number);

/// "the second operand of ADD", "the texture target of TEX".
[[nodiscard]] std::string partName(ir::Opcode op, Part part);

/// True of the part that stands right behind the opcode.
[[nodiscard]] bool beginsInstruction(ir::Opcode op, Part part);

/// How many parts an instruction has; 0 for one that branches.
[[nodiscard]] int partCount(ir::Opcode op);

/// True if a line ends between two positions of a text.
[[nodiscard]] bool isOnLaterLine(std::string_view text, std::uint32_t from, std::uint32_t to);

/// True if a word begins a line and another word or '=' follows it in that line. No statement goes
/// on so, and a parser that has skipped to there may read on: the word begins a statement, even if
/// an unknown one. \param last the token before \p first
[[nodiscard]] bool beginsLine(std::string_view text, Span last, const Token &first);

/// The parts of a statement as its text has them, without the white space around them.
using PartTexts = std::vector<std::string_view>;

/// Returns the parts between \p begin, behind the statement's first word, and the statement's end,
/// which may lack its semicolon; none if so many tokens of it tell nothing.
[[nodiscard]] PartTexts partsBehind(std::string_view text, std::uint32_t begin);

/// Returns a part of the author's statement, for a hint that shows how it is written.
/// \param otherwise what stands for a part that is missing, or that is no single value
/// \param scalar gives it one component: "a.x", "{2.0}.x"
[[nodiscard]] std::string shownPart(const PartTexts &parts, std::size_t index,
                                    std::string_view otherwise, bool scalar = false);

/// Returns a value with one component: "a.x" of "a" and "a.xyz", "{2.0}.x" of "2.0".
[[nodiscard]] std::string withComponent(std::string_view value);

/// Returns the hint for a scalar operand that has no component: "write a.x".
[[nodiscard]] std::string componentHint(std::string_view operand);

/// How an instruction is written, with the author's own names: "write ADD r, a, second;".
/// \param unit how a texture image unit is: "texture[0]"
[[nodiscard]] std::string usageHint(ir::Opcode op, const PartTexts &parts,
                                    std::string_view unit = "texture[0]");

} // namespace arbiter::fp
