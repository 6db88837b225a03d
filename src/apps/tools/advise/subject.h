#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "apps/tools/advise/cost.h"
#include "apps/tools/advise/flow.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/front/words/names.h"

/// The program to improve: its text, its compiled form, and the spelling of its parts.
namespace arbiter::tools::advise {

/// The language and limits under which a program is examined.
struct Setting {
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  fp::Limits limits; ///< of the language's target
};

/// The longest program that gets suggestions. Each suggestion is tested by compiling and running
/// the whole program.
inline constexpr std::size_t kMaxInstructions = 1024;

class Subject {
public:
  /// Compiles a text. Returns nothing if it does not load, is in the language of ATI or nvparse,
  /// uses an NVIDIA option, or is too long. The text must outlive the subject.
  [[nodiscard]] static std::unique_ptr<Subject> read(std::string_view text, const Setting &setting);
  Subject(const Subject &) = delete;
  Subject &operator=(const Subject &) = delete;

  [[nodiscard]] std::string_view text() const { return m_text; }
  [[nodiscard]] const Setting &setting() const { return m_setting; }
  [[nodiscard]] const fp::ir::Program &program() const { return *m_check.program; }
  [[nodiscard]] const fp::ir::Instruction &at(std::uint32_t index) const {
    return program().code[index];
  }
  [[nodiscard]] std::uint32_t size() const { return std::uint32_t(program().code.size()); }
  [[nodiscard]] const Flow &flow() const { return m_flow; }
  [[nodiscard]] Cost cost() const { return costOf(m_check); }
  /// Returns the unit for which the program runs, "pixel" or "vertex".
  [[nodiscard]] const char *fragmentOrVertex() const {
    return m_setting.language == fp::ir::Language::ArbVertex ? "vertex" : "pixel";
  }

  /// Returns a range of the text without white space and comments.
  [[nodiscard]] std::string tokens(fp::Span span) const;
  /// Returns an operand's register as in the text, without sign and suffix: "step",
  /// "fragment.texcoord[0]".
  [[nodiscard]] std::string base(std::uint32_t index, int operand) const;
  /// Returns an operand that reads the register \p base in the way that \p like reads its own, at
  /// the positions of \p mask. Returns nothing if a plain operand cannot express it: differing
  /// signs, constant selectors.
  [[nodiscard]] static std::optional<std::string>
  spelled(const std::string &base, const fp::ir::Operand &like, std::uint8_t mask, bool scalar);
  /// Returns an existing operand for an instruction that reads it at the positions of \p mask.
  [[nodiscard]] std::optional<std::string> spelled(std::uint32_t index, int operand,
                                                   std::uint8_t mask, bool scalar) const;
  /// Returns the destination's register and mask.
  [[nodiscard]] std::string destination(std::uint32_t index) const;
  /// Returns the destination's register without its mask.
  [[nodiscard]] std::string destinationBase(std::uint32_t index) const;

  /// Returns the constant that an operand reads at a position, if it is one.
  [[nodiscard]] std::optional<float> number(std::uint32_t index, int operand, int position) const;
  /// Returns the constant that an operand reads at all positions that count, if they are equal.
  [[nodiscard]] std::optional<float> number(std::uint32_t index, int operand) const;

  /// Returns an unused name: the stem, or the stem followed by a number.
  [[nodiscard]] std::string fresh(const std::string &stem) const;

private:
  Subject(std::string_view text, const Setting &setting, fp::CheckResult check);

  std::string_view m_text;
  Setting m_setting;
  fp::CheckResult m_check;
  Flow m_flow;
};

/// Returns a mask's text, such as ".xz"; empty for all four components.
[[nodiscard]] std::string maskText(std::uint8_t mask);
/// Returns a number's text as an operand, such as "0.5", which parses to the same number.
[[nodiscard]] std::string numberText(float value);
/// Returns a vector's text, such as "{1, 0.5, 0, 1}".
[[nodiscard]] std::string vectorText(const fp::ir::Vec4 &value);
/// Returns a statement: "MUL_SAT r.x, a, b", or "TEX r, a, texture[0], 2D" with the texture as the
/// last operand.
[[nodiscard]] std::string statementText(fp::ir::Opcode op, bool saturate,
                                        const std::string &destination,
                                        const std::vector<std::string> &operands);
/// Returns a texture's operands: ", texture[2], CUBE".
[[nodiscard]] std::string textureText(unsigned unit, fp::ir::TexTarget target);

} // namespace arbiter::tools::advise
