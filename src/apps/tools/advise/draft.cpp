#include "apps/tools/advise/draft.h"

#include <algorithm>

#include "fp_compiler/ir/reads.h"

namespace arbiter::tools::advise {

Draft &Draft::replace(std::uint32_t index, const std::string &statement) {
  m_edits.push_back({m_subject.at(index).span, statement});
  return *this;
}

Draft &Draft::replaceOperand(std::uint32_t index, int operand, const std::string &text) {
  m_edits.push_back({m_subject.at(index).src[std::size_t(operand)].span, text});
  return *this;
}

Draft &Draft::remove(std::uint32_t index) {
  m_edits.push_back({wholeStatement(m_subject.text(), m_subject.at(index).span), ""});
  return *this;
}

Draft &Draft::insert(std::uint32_t index, const std::vector<std::string> &statements) {
  m_edits.push_back(insertedBefore(m_subject.text(), m_subject.at(index).span.begin, statements));
  return *this;
}

Proposal Draft::about(std::uint32_t index, const char *rule, std::string message,
                      Nearness nearness) const {
  return about(index, index, rule, std::move(message), nearness);
}

Proposal Draft::about(std::uint32_t first, std::uint32_t last, const char *rule,
                      std::string message, Nearness nearness) const {
  Proposal proposal;
  proposal.rule = rule;
  proposal.span = {m_subject.at(first).span.begin, m_subject.at(last).span.end};
  proposal.message = std::move(message);
  proposal.edits = m_edits;
  sort(proposal.edits);
  proposal.nearness = nearness;
  return proposal;
}

std::string restated(const Subject &subject, std::uint32_t index, const std::string &destination,
                     bool saturate) {
  const fp::ir::Instruction &instruction = subject.at(index);
  const std::uint32_t begin = instruction.src[0].span.begin;
  return statementText(instruction.op, saturate, destination,
                       {subject.tokens({begin, instruction.span.end})});
}

Operand composed(const Operand &outer, const Operand &inner) {
  Operand result = inner;
  result.negate = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Select select = outer.swizzle[i];
    const bool register_ = select <= Select::W;
    const std::size_t from = register_ ? std::size_t(select) : 0;
    result.swizzle[i] = register_ ? inner.swizzle[from] : select;
    const bool sign = (outer.negate >> i & 1) != (register_ && (inner.negate >> from & 1));
    result.negate = std::uint8_t(result.negate | (sign ? 1 << i : 0));
  }
  return result;
}

void readInstead(const Subject &subject, std::uint32_t index, const std::string &name,
                 Draft &draft) {
  const Flow &flow = subject.flow();
  const fp::ir::Instruction &instruction = subject.at(index);
  std::vector<std::pair<Use, std::string>> reads;
  bool all = instruction.dst.file == fp::ir::File::Temporary && flow.readAlone(index);
  for (const Use &use : flow.uses(index)) {
    const fp::ir::Instruction &reader = subject.at(use.reader);
    const bool extended = reader.op == fp::ir::Opcode::Swz; // SWZ has its suffix elsewhere
    const bool scalar = fp::ir::info(reader.op).shapes[use.operand] == 'S';
    const auto text = extended ? std::optional(name)
                               : Subject::spelled(name, reader.src[std::size_t(use.operand)],
                                                  fp::ir::operandMask(reader, use.operand), scalar);
    all = all && text;
    reads.emplace_back(use, text.value_or(""));
  }
  if (!all) {
    draft.replace(index,
                  statementText(fp::ir::Opcode::Mov, false, subject.destination(index), {name}));
    return;
  }
  for (const auto &[use, text] : reads)
    draft.replaceOperand(use.reader, use.operand, text);
  draft.remove(index);
}

} // namespace arbiter::tools::advise
