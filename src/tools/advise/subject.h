#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "fp_compiler/compiler.h"
#include "fp_compiler/front/words/names.h"
#include "tools/advise/cost.h"
#include "tools/advise/flow.h"

/// A program that advice is looked for in: its text, what it means, and how its parts are spelled.
namespace arbiter::tools::advise {

/// Under which a program is looked at.
struct Setting {
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  fp::Limits limits; ///< of the language's target
};

/// Longer programs get no advice: each piece is checked by compiling and running the whole.
inline constexpr std::size_t kMaxInstructions = 1024;

class Subject {
public:
  /// Nothing for a text that does not load, is in ATI's language, or is too long. The text must
  /// outlive the subject.
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
  /// "pixel" or "vertex": what the program is run for.
  [[nodiscard]] const char *fragmentOrVertex() const {
    return m_setting.language == fp::ir::Language::ArbVertex ? "vertex" : "pixel";
  }

  /// A range of bytes without white space and comments.
  [[nodiscard]] std::string tokens(fp::Span span) const;
  /// The register of an operand as the text names it, without sign and suffix: "step",
  /// "fragment.texcoord[0]".
  [[nodiscard]] std::string base(std::uint32_t index, int operand) const;
  /// An operand that reads the register \p base as \p like reads its own, at the positions of
  /// \p mask. Nothing where a plain operand cannot say it: signs that differ, constant selectors.
  [[nodiscard]] static std::optional<std::string>
  spelled(const std::string &base, const fp::ir::Operand &like, std::uint8_t mask, bool scalar);
  /// The operand as it stands there, for an instruction that reads it at the positions of \p mask.
  [[nodiscard]] std::optional<std::string> spelled(std::uint32_t index, int operand,
                                                   std::uint8_t mask, bool scalar) const;
  /// The destination's register and mask.
  [[nodiscard]] std::string destination(std::uint32_t index) const;
  /// The destination's register alone.
  [[nodiscard]] std::string destinationBase(std::uint32_t index) const;

  /// The number that an operand reads at a position, if it is one.
  [[nodiscard]] std::optional<float> number(std::uint32_t index, int operand, int position) const;
  /// The number that it reads at all positions that count, if it is one and the same.
  [[nodiscard]] std::optional<float> number(std::uint32_t index, int operand) const;

  /// A name that the text does not have: the stem, or the stem with a number behind.
  [[nodiscard]] std::string fresh(const std::string &stem) const;

private:
  Subject(std::string_view text, const Setting &setting, fp::CheckResult check);

  std::string_view m_text;
  Setting m_setting;
  fp::CheckResult m_check;
  Flow m_flow;
};

/// ".xz", of a mask; empty for all four.
[[nodiscard]] std::string maskText(std::uint8_t mask);
/// "0.5": a number as an operand's text, which reads the same.
[[nodiscard]] std::string numberText(float value);
/// "{1, 0.5, 0, 1}"
[[nodiscard]] std::string vectorText(const fp::ir::Vec4 &value);
/// "MUL_SAT r.x, a, b", or "TEX r, a, texture[0], 2D" with the texture as the last operand.
[[nodiscard]] std::string statementText(fp::ir::Opcode op, bool saturate,
                                        const std::string &destination,
                                        const std::vector<std::string> &operands);
/// ", texture[2], CUBE"
[[nodiscard]] std::string textureText(unsigned unit, fp::ir::TexTarget target);

} // namespace arbiter::tools::advise
