#include "tools/lsp/completion.h"

namespace arbiter::tools::lsp {

using fp::TokenKind;

/// Every place takes functions; registers are named where something is written or read.
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
