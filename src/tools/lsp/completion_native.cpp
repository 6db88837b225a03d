// Statements of NVIDIA's own languages, whose registers have numbers and are not declared.

#include "tools/lsp/completion.h"

#include "fp_compiler/front/nv/words.h"

namespace arbiter::tools::lsp {

using fp::Keyword;
using fp::TokenKind;

namespace {
struct WordRow {
  bool vertex;
  std::string_view name, doc;
};
constexpr WordRow kAttributes[] = {
#define NATIVE_ATTRIBUTE(Stage, name, number, Kind, doc)                                           \
  {std::string_view(#Stage) == "Vertex", name, doc},
#include "fp_compiler/front/native/words.def"
};
constexpr WordRow kResults[] = {
#define NATIVE_RESULT(Stage, name, Kind, doc) {std::string_view(#Stage) == "Vertex", name, doc},
#include "fp_compiler/front/native/words.def"
};
struct HeaderRow {
  std::string_view header, doc;
};
constexpr HeaderRow kHeaders[] = {
#define NATIVE_LANGUAGE(Enumerator, header, specification, doc) {header, doc},
#include "fp_compiler/front/native/words.def"
};
struct KeywordRow {
  std::string_view word, doc;
};
constexpr KeywordRow kKeywords[] = {
#define NATIVE_KEYWORD(word, languages, doc) {word, doc},
#include "fp_compiler/front/native/words.def"
};
constexpr int kTexCoords = 8;
} // namespace

void Completion::addOwnHeaders() {
  for (const HeaderRow &row : kHeaders)
    add(row.header, kKeyword, std::string(row.doc));
}

void Completion::inOwnStatement() {
  const bool first = m_next == 0 || m_reading.kind(m_next - 1) == TokenKind::Semicolon;
  const std::size_t begin = first ? m_next : m_reading.statementBegin(m_next - 1);
  const Keyword keyword = first ? Keyword::None : m_reading.word(begin).keyword;
  if (keyword == Keyword::Opcode)
    inOwnInstruction();
  else if (keyword == Keyword::Option && m_next == begin + 1)
    add("NV_position_invariant", kEnumMember, "the position of fixed function");
  else if (keyword == Keyword::None && m_next <= begin + 1)
    addOwnStatements();
}

void Completion::addOwnStatements() {
  const fp::ir::NativeLanguage language = m_view.analysis.ownLanguage;
  for (int i = 0; i < fp::ir::kOpcodeRowCount; ++i) {
    const auto op = fp::ir::Opcode(i);
    if (fp::nv::offers(language, op))
      add(info(op).mnemonic, kFunction, signatureOf(op, m_language), documentationOf(op));
  }
  for (const KeywordRow &row : kKeywords)
    if (fp::nv::classify(row.word, language).keyword != Keyword::None)
      add(row.word, kKeyword, std::string(row.doc));
}

/// The names of attributes or results, as far as they are no temporaries.
void Completion::inOwnInstruction() {
  if (insideBrackets())
    return;
  const Operand here = operand();
  const bool vertex = m_language == fp::ir::Language::ArbVertex;
  const bool states = m_view.analysis.ownLanguage == fp::ir::NativeLanguage::Vsp1;
  const auto addAll = [&](std::span<const WordRow> rows, const std::string &letter) {
    for (const WordRow &row : rows)
      if (row.vertex == vertex)
        add(letter + "[" + std::string(row.name) + "]", kModule, std::string(row.doc));
    for (int i = 0; vertex == (letter != "f") && i < kTexCoords; ++i)
      add(letter + "[TEX" + std::to_string(i) + "]", kModule, "texture coordinates");
  };
  if (here.number < 0 && !states)
    return addAll(kResults, "o");
  if (here.number >= info(here.op).operandCount() || here.number < 0)
    return;
  if (!states)
    addAll(kAttributes, vertex ? "v" : "f");
  addNames({fp::SymbolKind::Parameter});
}

} // namespace arbiter::tools::lsp
