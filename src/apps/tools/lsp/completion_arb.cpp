#include "apps/tools/lsp/completion.h"

#include <algorithm>

#include "apps/tools/language.h"
#include "fp_compiler/front/nv/words.h"

namespace arbiter::tools::lsp {

using fp::Keyword;
using fp::SymbolKind;
using fp::TokenKind;
using fp::reference::Entry;

namespace {
constexpr Kinds kSources = {SymbolKind::Temporary, SymbolKind::Attribute, SymbolKind::Parameter,
                            SymbolKind::ParameterArray};
constexpr Kinds kDestinations = {SymbolKind::Temporary, SymbolKind::Output};
constexpr Kinds kAddresses = {SymbolKind::Address};
constexpr Kinds kVariables = {SymbolKind::Temporary, SymbolKind::Attribute,
                              SymbolKind::Parameter, SymbolKind::ParameterArray,
                              SymbolKind::Output,    SymbolKind::Address};

// Attribute and result names of NVIDIA's own languages.
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

void Completion::inStatement() {
  const bool first = m_next == 0 || m_reading.kind(m_next - 1) == TokenKind::Semicolon;
  const std::size_t begin = first ? m_next : m_reading.statementBegin(m_next - 1);
  if (first)
    return addStatements();
  switch (m_reading.word(begin).keyword) {
  case Keyword::Opcode:
    return inInstruction();
  case Keyword::Option:
    if (m_next == begin + 1)
      addOptions();
    return;
  case Keyword::Attrib:
    return afterEquals({Keyword::Attributes}, {});
  case Keyword::Output:
    return afterEquals({Keyword::Result}, {});
  case Keyword::Param:
    return afterEquals({Keyword::Program, Keyword::State}, {});
  case Keyword::Alias:
    return afterEquals({}, kVariables);
  case Keyword::None:
    // A word that begins no statement may be an unfinished one.
    return m_next <= begin + 1 ? addStatements() : void();
  default:
    return;
  }
}

/// Adds the options that the profile's card supports.
void Completion::addOptions() {
  const std::uint32_t nvOptions = m_view.analysis.limits.nvOptions;
  for (const Entry &entry : fp::reference::options(m_language)) {
    const bool second = entry.word == "NV_fragment_program2" || entry.word == "NV_vertex_program3";
    const std::uint32_t needed = !entry.word.starts_with("NV_") ? 0 : second ? 2 : 1;
    if (needed <= nvOptions)
      add(std::span(&entry, 1), kEnumMember);
  }
}

void Completion::addStatements() {
  for (int i = 0; i < fp::ir::kOpcodeCount; ++i) {
    const auto op = fp::ir::Opcode(i);
    if (info(op).has(fp::arbLanguage(m_language).foreign))
      continue;
    add(info(op).mnemonic, kFunction, signatureOf(op, m_language), documentationOf(op));
    if (fp::arbLanguage(m_language).saturates && !info(op).has(fp::ir::Kills))
      add(std::string(info(op).mnemonic) + "_SAT", kFunction,
          "the result clamped to [0, 1]: " + signatureOf(op, m_language), documentationOf(op));
  }
  for (const Entry &entry : fp::reference::keywords(m_language))
    if (fp::beginsStatement(fp::classify(entry.word, fp::arbLanguage(m_language)).keyword))
      add(entry.word, kKeyword, std::string(entry.doc), documentationOf(entry));
  addNvOpcodes();
}

/// Adds the opcodes of the text's NV option. Suffixes are left to the writer.
void Completion::addNvOpcodes() {
  const fp::ir::NvOption option = m_view.analysis.nv;
  if (option == fp::ir::NvOption::None)
    return;
  const fp::ArbLanguage &language = fp::arbLanguage(m_language);
  for (int i = 0; i < fp::ir::kOpcodeRowCount; ++i) {
    const auto op = fp::ir::Opcode(i);
    const bool known = i < fp::ir::kOpcodeCount && !info(op).has(language.foreign);
    if (!known && fp::nv::offers(language, option, op))
      add(info(op).mnemonic, kFunction, signatureOf(op, m_language), documentationOf(op));
  }
}

void Completion::addKeywords(std::initializer_list<Keyword> keywords) {
  for (const Entry &entry : fp::reference::keywords(m_language)) {
    const Keyword keyword = fp::classify(entry.word, fp::arbLanguage(m_language)).keyword;
    if (std::find(keywords.begin(), keywords.end(), keyword) != keywords.end())
      add(entry.word, kModule, std::string(entry.doc), documentationOf(entry));
  }
}

void Completion::addNames(Kinds kinds) {
  for (const fp::Name &name : m_view.analysis.inspection.names.names()) {
    // A name does not exist before its declaration.
    if (name.declared.end == 0 || name.declared.end > m_replaced.begin ||
        std::find(kinds.begin(), kinds.end(), name.kind) == kinds.end())
      continue;
    const auto token = m_reading.at(name.declared.begin);
    const bool constant =
        name.kind == SymbolKind::Parameter || name.kind == SymbolKind::ParameterArray;
    add(name.text, constant ? kConstant : kVariable,
        token ? std::string(m_view.document.text(m_reading.statement(*token)).substr(0, 80))
              : std::string());
  }
}

void Completion::afterEquals(std::initializer_list<Keyword> keywords, Kinds kinds) {
  const TokenKind before = m_reading.kind(m_next - 1);
  if (before != TokenKind::Equals && before != TokenKind::OpenBrace && before != TokenKind::Comma)
    return;
  addKeywords(keywords);
  addNames(kinds);
}

void Completion::inInstruction() {
  if (insideBrackets() && m_reading.kind(m_next - 1) == TokenKind::OpenBracket)
    return addNames(kAddresses);
  const TokenKind before = m_reading.kind(m_next - 1);
  const Operand here = operand();
  const fp::ir::OpInfo &op = info(here.op);
  const bool opens = m_next - 1 == m_reading.statementBegin(m_next - 1) ||
                     before == TokenKind::Comma || before == TokenKind::Minus ||
                     before == TokenKind::Plus;
  if (!opens)
    return;
  if (here.number < 0) {
    if (here.op == fp::ir::Opcode::Arl)
      return addNames(kAddresses);
    addNames(kDestinations);
    return addKeywords({Keyword::Result});
  }
  if (here.number < op.operandCount()) {
    addNames(kSources);
    return addKeywords({Keyword::Attributes, Keyword::Program, Keyword::State});
  }
  if (here.op == fp::ir::Opcode::Swz)
    for (const char *selector : {"x", "y", "z", "w", "0", "1"})
      add(selector, kValue, "selector, with or without a sign before it");
  else if (op.has(fp::ir::Texture) && here.number == op.operandCount())
    for (std::uint32_t unit = 0; unit < m_view.analysis.limits.textureImageUnits; ++unit)
      add("texture[" + std::to_string(unit) + "]", kModule, "texture image unit");
  else if (op.has(fp::ir::Texture) && here.number == op.operandCount() + 1)
    add(fp::reference::targets(), kEnumMember);
}

// Statements of NVIDIA's own languages, whose registers are numbered and not declared.

void Completion::addOwnHeaders() {
  for (const HeaderRow &row : kHeaders) {
    const fp::ir::NativeLanguage language = fp::nativeLanguageOf(row.header);
    if (fp::takesLanguage(limitsOf(m_view.profile, fp::stageOf(language)), language))
      add(row.header, kKeyword, std::string(row.doc));
  }
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

/// Adds the names of attributes or results; temporaries need none.
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
