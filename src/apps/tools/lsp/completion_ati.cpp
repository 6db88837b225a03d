#include "apps/tools/lsp/completion.h"

#include <algorithm>

namespace arbiter::tools::lsp {

using fp::TokenKind;

void Completion::inAtiStatement() {
  const bool first = m_next == 0 || m_reading.kind(m_next - 1) == TokenKind::Semicolon;
  if (first) {
    for (const auto &op : fp::reference::atiOps())
      add(op.word, kFunction, signatureOf(op), documentationOf(op));
    return add(fp::reference::atiStatements(), kKeyword);
  }
  const std::size_t begin = m_reading.statementBegin(m_next - 1);
  const std::string_view word = m_reading.text(begin);
  const TokenKind before = m_reading.kind(m_next - 1);
  if (word == "CONSTANT")
    return before == TokenKind::Equals ? add("program", kModule, "env or local parameters")
           : m_next == begin + 1       ? addAtiSources("c")
                                       : void();
  if (m_next == begin + 1)
    return addAtiSources("r");
  if (before != TokenKind::Comma)
    return;
  if (word == "PassTexCoord" || word == "SampleMap") {
    addAtiSources("t");
    return addAtiSources("r");
  }
  for (const char *source : {"r", "c", "color0", "color1"})
    addAtiSources(source);
  add("0", kValue, "zero");
  add("1", kValue, "one");
}

void Completion::addAtiSources(std::string_view word) {
  for (const auto &source : fp::reference::atiSources()) {
    if (source.word != word)
      continue;
    if (source.count == 0)
      add(word, kVariable, std::string(source.doc));
    for (int i = 0; i < source.count; ++i)
      add(std::string(word) + std::to_string(i), kVariable, std::string(source.doc));
  }
}

void Completion::addAtiSuffixes(bool nested) {
  const std::size_t begin = m_reading.statementBegin(m_next - 1);
  const std::string_view word = m_reading.text(begin);
  if (word == "PassTexCoord" || word == "SampleMap")
    return nested ? void() : add(fp::reference::atiCoordinates(), kProperty);
  if (word == "CONSTANT")
    return;
  if (m_reading.comma(begin, m_next) != m_next) {
    for (const char *component : {"r", "g", "b", "a"})
      add(component, kProperty, "this component in all four");
    return add(fp::reference::atiArgumentModifiers(), kProperty);
  }
  for (const char *mask : {"r", "g", "b", "a", "rgb", "rgba"})
    add(mask, kProperty, "write mask");
  add(fp::reference::atiDestinationModifiers(), kProperty);
}

/// Adds functions at every position, and registers where a value is written or read.
void Completion::inNvparseStatement() {
  const TokenKind before = m_next == 0 ? TokenKind::Semicolon : m_reading.kind(m_next - 1);
  const bool first = before == TokenKind::Semicolon || before == TokenKind::OpenBrace ||
                     before == TokenKind::CloseBrace;
  add(fp::reference::nvparseWords(m_language), kFunction);
  if (m_language == fp::ir::Language::Combiners || !first)
    addNvparseRegisters();
}

void Completion::addNvparseRegisters() {
  for (const auto &row : fp::reference::nvparseRegisters()) {
    if (row.count == 0)
      add(row.word, kVariable, std::string(row.doc));
    for (int i = 0; i < row.count; ++i)
      add(std::string(row.word) + std::to_string(i), kVariable, std::string(row.doc));
  }
}

} // namespace arbiter::tools::lsp
