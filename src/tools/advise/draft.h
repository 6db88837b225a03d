#pragma once
#include <string>
#include <vector>

#include "tools/advise/proposal.h"
#include "tools/advise/subject.h"

namespace arbiter::tools::advise {

/// Edits of a program in terms of its statements, which rules build proposals of.
class Draft {
public:
  explicit Draft(const Subject &subject) : m_subject(subject) {}

  /// The statement's text, without the semicolon, becomes another.
  Draft &replace(std::uint32_t index, const std::string &statement);
  /// One operand's text becomes another.
  Draft &replaceOperand(std::uint32_t index, int operand, const std::string &text);
  /// The statement goes.
  Draft &remove(std::uint32_t index);
  /// Statements that come before it.
  Draft &insert(std::uint32_t index, const std::vector<std::string> &statements);

  /// A proposal about the statement.
  [[nodiscard]] Proposal about(std::uint32_t index, const char *rule, std::string message,
                               Nearness nearness = Nearness::Exact) const;
  /// A proposal about the statements from one to another.
  [[nodiscard]] Proposal about(std::uint32_t first, std::uint32_t last, const char *rule,
                               std::string message, Nearness nearness = Nearness::Exact) const;

private:
  const Subject &m_subject;
  Edits m_edits;
};

/// The rest of an opcode's name and operands after a change of the destination: "RCP_SAT d, a.x".
[[nodiscard]] std::string restated(const Subject &subject, std::uint32_t index,
                                   const std::string &destination, bool saturate);

/// An operand that reads through: position i of \p outer reads what \p inner reads at the component
/// of its destination. Requires: the instruction of \p inner is per component.
[[nodiscard]] fp::ir::Operand composed(const fp::ir::Operand &outer, const fp::ir::Operand &inner);

/// Makes reads of an instruction's result reads of the register \p name, and the instruction go; or
/// a copy of that register, where a reader mixes it with what others wrote, or the result is no
/// temporary.
void readInstead(const Subject &subject, std::uint32_t index, const std::string &name,
                 Draft &draft);

} // namespace arbiter::tools::advise
