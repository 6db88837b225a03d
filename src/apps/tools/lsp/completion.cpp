#include "apps/tools/lsp/completion.h"

#include <algorithm>

#include "apps/scene/panel/complete.h"
#include "apps/tools/language.h"

namespace arbiter::tools::lsp {

using fp::Keyword;
using fp::TokenKind;
using fp::reference::Entry;
using fp::reference::Index;

Json Completion::run() {
  if (m_reading.inComment(m_replaced.begin)) {
    addPanelWords();
    return m_items;
  }
  const bool own = m_view.analysis.ownLanguage != fp::ir::NativeLanguage::None;
  const std::string header = own ? std::string(fp::ir::headerOf(m_view.analysis.ownLanguage))
                                 : languageRow(m_language).header;
  const std::uint32_t begin = m_view.analysis.program.span.begin;
  const std::string_view source = m_view.source();
  if (!source.starts_with(header) &&
      m_view.document.map().lineOf(m_replaced.begin) == m_view.document.map().lineOf(begin))
    addHeaders();
  if (m_replaced.begin < begin + header.size() && source.starts_with("!"))
    return m_items; // the position is within the header
  if (m_next > 0 && m_reading.kind(m_next - 1) == TokenKind::Dot)
    behindDot();
  else if (m_language == fp::ir::Language::AtiFragment)
    inAtiStatement();
  else if (isNvparse(m_language))
    inNvparseStatement();
  else if (own)
    inOwnStatement();
  else
    inStatement();
  return m_items;
}

/// Adds words for a comment that begins with #@, which is a line of the panel.
void Completion::addPanelWords() {
  const auto place = scene::completePanel(m_view.document.text(), m_offset);
  if (!place)
    return;
  m_replaced = place->replaced;
  for (const scene::Candidate &candidate : place->candidates)
    add(candidate.word, kKeyword, {}, std::string(candidate.meaning));
}

void Completion::add(std::string_view word, ItemKind kind, const std::string &detail,
                     const std::string &documentation) {
  Json item = {{"label", std::string(word)},
               {"kind", int(kind)},
               {"textEdit", {{"range", m_view.range(m_replaced)}, {"newText", std::string(word)}}}};
  if (!detail.empty())
    item["detail"] = detail;
  if (!documentation.empty())
    item["documentation"] = {{"kind", "markdown"}, {"value", documentation}};
  m_items.push_back(std::move(item));
}

void Completion::add(std::span<const Entry> entries, ItemKind kind) {
  for (const Entry &entry : entries)
    if (!entry.word.empty())
      add(entry.word, kind, std::string(entry.doc), documentationOf(entry));
}

void Completion::addHeaders() {
  m_replaced = m_view.headerLine();
  const std::string_view line = m_view.document.text(m_replaced);
  // Another word on the first line is not the start of a header, and is kept.
  if (!line.empty() && line[0] != '!') {
    m_replaced = {m_replaced.begin, m_replaced.begin};
    return;
  }
  const auto offered = [&](fp::ir::Language language) {
    const fp::Limits own = limitsOf(m_view.profile, language);
    return language == fp::ir::Language::TextureShaders ? own.textureShaders != 0
                                                        : own.generalCombiners != 0;
  };
  for (const LanguageRow &row : languageRows())
    if (!isNvparse(row.language) || offered(row.language))
      add(row.header, kKeyword, "the first bytes of the text");
  addOwnHeaders();
}

void Completion::behindDot() {
  if (m_next < 2)
    return;
  std::size_t word = m_next - 2;
  if (m_reading.kind(word) == TokenKind::CloseBracket)
    while (word > 0 && m_reading.kind(word) != TokenKind::OpenBracket)
      --word;
  if (m_reading.kind(word) == TokenKind::OpenBracket && word > 0)
    --word;
  const std::vector<std::string_view> path = m_reading.words(m_reading.chainUpTo(word));
  if (path.empty())
    return;
  for (const auto &segment : fp::reference::wordsBehind(m_language, path))
    addSegment(path, segment);
  if (m_language == fp::ir::Language::AtiFragment)
    return addAtiSuffixes(path.size() > 1);
  const bool binding = fp::reference::findBinding(m_language, path) != nullptr;
  const bool name = path.size() == 1 && m_view.analysis.inspection.names.find(path[0]);
  const Operand here = operand();
  if ((binding || name) && here.known)
    addComponents(here);
  else if (name && m_reading.kind(word + 1) == TokenKind::Dot && insideBrackets())
    add("x", kProperty, "an address register has this component only");
}

void Completion::addSegment(std::vector<std::string_view> path,
                            const fp::reference::Segment &segment) {
  path.push_back(segment.word);
  const auto *binding = fp::reference::findBinding(m_language, path);
  std::string text(segment.word);
  text += segment.index == Index::Required ? "[" : "";
  add(text, kProperty, binding ? std::string(binding->doc) : std::string(),
      binding ? documentationOf(*binding) : std::string());
  m_items.back()["label"] = std::string(segment.word) + (segment.index == Index::Required   ? "[n]"
                                                         : segment.index == Index::Optional ? "[n]?"
                                                                                            : "");
  m_items.back()["filterText"] = std::string(segment.word);
}

Completion::Operand Completion::operand() const {
  Operand here;
  if (m_next == 0)
    return here;
  const std::size_t begin = m_reading.statementBegin(m_next - 1);
  const fp::Word word = m_reading.word(begin);
  if (word.keyword != Keyword::Opcode)
    return here;
  here.known = true;
  here.op = word.op;
  here.number = info(word.op).has(fp::ir::Kills) ? 0 : -1;
  int braces = 0;
  for (std::size_t i = begin; i < m_next; ++i) {
    const TokenKind kind = m_reading.kind(i);
    braces += (kind == TokenKind::OpenBrace) - (kind == TokenKind::CloseBrace);
    here.number += kind == TokenKind::Comma && braces == 0 ? 1 : 0;
  }
  return here;
}

bool Completion::insideBrackets() const {
  for (std::size_t i = m_next; i-- > 0;) {
    if (m_reading.kind(i) == TokenKind::OpenBracket)
      return true;
    if (m_reading.kind(i) == TokenKind::CloseBracket || m_reading.kind(i) == TokenKind::Semicolon)
      return false;
  }
  return false;
}

void Completion::addComponents(const Operand &here) {
  const bool address = here.op == fp::ir::Opcode::Arl && here.number < 0;
  const bool colors = fp::arbLanguage(m_language).colorLetters;
  if (here.number < 0) {
    if (address)
      return add("x", kProperty, "an address register has this component only");
    for (const char *mask : {"x", "y", "z", "w", "xy", "xyz", "xyzw", "xw", "yz", "zw"})
      add(mask, kProperty, "write mask");
    if (colors)
      for (const char *mask : {"rgb", "a", "rgba"})
        add(mask, kProperty, "write mask");
    return;
  }
  for (const char *component : {"x", "y", "z", "w"})
    add(component, kProperty, "this component in all four");
  if (colors)
    for (const char *component : {"r", "g", "b", "a"})
      add(component, kProperty, "this component in all four");
  if (!here.scalar())
    for (const char *swizzle : {"xyzw", "wzyx", "yzxw", "zxyw", "xyxy", "zwzw"})
      add(swizzle, kProperty, "swizzle");
}

Json completion(const View &view, std::uint32_t offset) { return Completion(view, offset).run(); }

} // namespace arbiter::tools::lsp
