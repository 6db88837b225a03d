#include "fp_compiler/front/nv/labels.h"

namespace arbiter::fp::nv {

std::uint16_t Labels::numberOf(Span name) {
  if (const auto known = m_numbers.find(text(name)); known != m_numbers.end())
    return known->second;
  if (m_labels.size() == kNoLabel) {
    m_reporter.error(DiagnosticId::NvFlow, name, "too many labels in any program");
    return kNoLabel - 1;
  }
  const auto number = std::uint16_t(m_labels.size());
  m_labels.push_back({name, false});
  m_numbers.emplace(text(name), number);
  return number;
}

Statement Labels::place(Span name) {
  Statement statement;
  statement.isLabel = true;
  statement.label = numberOf(name);
  statement.instruction.span = name;
  Label &label = m_labels[statement.label];
  if (label.placed)
    m_reporter.error(DiagnosticId::RedeclaredName, name,
                     "the label " + quote(text(name)) + " stands twice", "rename one of the two");
  label.placed = true;
  return statement;
}

void Labels::check() const {
  for (const Label &label : m_labels)
    if (!label.placed)
      m_reporter.error(DiagnosticId::UndeclaredName, label.name,
                       "the label " + quote(text(label.name)) + " is nowhere",
                       "write it before the instruction to go on with, and a colon");
}

std::optional<std::uint16_t> Labels::start() const {
  const auto found = m_numbers.find("main");
  return found == m_numbers.end() ? std::nullopt : std::optional(found->second);
}

} // namespace arbiter::fp::nv
