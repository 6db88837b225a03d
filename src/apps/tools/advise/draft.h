#pragma once
#include <string>
#include <vector>

#include "apps/tools/advise/proposal.h"
#include "apps/tools/advise/subject.h"

namespace arbiter::tools::advise {

/// Builds the edits of a proposal from changes of statements.
class Draft {
public:
  explicit Draft(const Subject &subject) : m_subject(subject) {}

  /// Replaces a statement's text, without the semicolon.
  Draft &replace(std::uint32_t index, const std::string &statement);
  /// Replaces the text of one operand.
  Draft &replaceOperand(std::uint32_t index, int operand, const std::string &text);
  /// Removes a statement.
  Draft &remove(std::uint32_t index);
  /// Inserts statements before a statement.
  Draft &insert(std::uint32_t index, const std::vector<std::string> &statements);

  /// Returns a proposal about one statement.
  [[nodiscard]] Proposal about(std::uint32_t index, const char *rule, std::string message,
                               Nearness nearness = Nearness::Exact) const;
  /// Returns a proposal about the statements from `first` to `last`.
  [[nodiscard]] Proposal about(std::uint32_t first, std::uint32_t last, const char *rule,
                               std::string message, Nearness nearness = Nearness::Exact) const;

private:
  const Subject &m_subject;
  Edits m_edits;
};

/// Returns an instruction's statement with another destination: "RCP_SAT d, a.x".
[[nodiscard]] std::string restated(const Subject &subject, std::uint32_t index,
                                   const std::string &destination, bool saturate);

/// Returns the operand of an instruction that reads \p inner directly instead of through \p outer.
/// Requires: the instruction of \p inner is per component.
[[nodiscard]] fp::ir::Operand composed(const fp::ir::Operand &outer, const fp::ir::Operand &inner);

/// Makes readers of an instruction's result read the register \p name, and removes the instruction.
/// If a reader also reads values of other instructions, or the result is no temporary, the
/// instruction becomes a copy of the register instead.
void readInstead(const Subject &subject, std::uint32_t index, const std::string &name,
                 Draft &draft);

} // namespace arbiter::tools::advise
