// Document symbols and semantic tokens.
#include <algorithm>
#include <iterator>

#include "apps/tools/lsp/answers.h"
#include "apps/tools/lsp/reading.h"
#include "fp_compiler/front/ati/words.h"
#include "fp_compiler/front/reference/reference.h"
#include "util/text/letters.h"

namespace arbiter::tools::lsp {

namespace {

using fp::SymbolKind;
using fp::TokenKind;

/// Returns the protocol's SymbolKind.
int kindOf(SymbolKind kind) {
  enum { kNamespace = 3, kProperty = 7, kVariable = 13, kConstant = 14, kArray = 18 };
  switch (kind) {
  case SymbolKind::Attribute:
  case SymbolKind::Output:
    return kProperty;
  case SymbolKind::Parameter:
    return kConstant;
  case SymbolKind::ParameterArray:
    return kArray;
  case SymbolKind::Temporary:
  case SymbolKind::Address:
  case SymbolKind::Unknown:
    break;
  }
  return kVariable;
}

/// Returns a statement on one line, shortened.
std::string oneLine(std::string_view text) {
  constexpr std::size_t kMax = 96;
  std::string line;
  for (const char c : text.substr(0, kMax)) {
    if (!isBlank(c) && !endsLine(c))
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  // Remove the bytes of a character that was cut.
  while (text.size() > kMax && !line.empty() && (std::uint8_t(line.back()) & 0x80) != 0)
    line.pop_back();
  return text.size() > kMax ? line + "..." : line;
}

Json declaration(const View &view, const Reading &reading, const fp::Name &name) {
  const auto token = reading.at(name.declared.begin);
  const fp::Span statement = token ? reading.statement(*token) : name.declared;
  const std::string_view text = view.document.text(statement);
  // In a list of registers each symbol's range is its own name, so that the ranges do not overlap.
  const bool list = text.starts_with("TEMP") || text.starts_with("ADDRESS");
  return {{"name", std::string(name.text)},
          {"detail", oneLine(text)},
          {"kind", kindOf(name.kind)},
          {"range", view.range(list ? name.declared : statement)},
          {"selectionRange", view.range(name.declared)}};
}

void addBlocks(const View &view, const Reading &reading, Json &all) {
  constexpr int kNamespace = 3;
  for (std::size_t i = 0; i < reading.size(); ++i) {
    const std::string_view word = reading.text(i);
    if (word != "StartPrelimPass" && word != "StartOutputPass")
      continue;
    std::size_t last = i;
    while (last + 1 < reading.size() && reading.text(last) != "EndPass" &&
           (last == i || !reading.text(last + 1).starts_with("Start")))
      ++last;
    all.push_back({{"name", word == "StartPrelimPass" ? "preliminary pass" : "output pass"},
                   {"kind", kNamespace},
                   {"range", view.range({reading.span(i).begin, reading.span(last).end})},
                   {"selectionRange", view.range(reading.span(i))}});
  }
}

constexpr const char *kTypes[] = {"keyword",  "function",   "variable", "parameter",
                                  "property", "enumMember", "number"};
enum Type { kKeyword, kFunction, kVariable, kParameter, kProperty, kEnumMember, kNumber, kNone };
constexpr const char *kModifiers[] = {"declaration", "readonly"};
enum Modifier { kDeclaration = 1, kReadonly = 2 };

/// Returns a token's type from its position and its word.
Type typeOf(const Reading &reading, std::size_t token, bool ati) {
  switch (reading.kind(token)) {
  case TokenKind::Integer:
  case TokenKind::Float:
    return kNumber;
  case TokenKind::Dimension:
    return kEnumMember;
  case TokenKind::Identifier:
    break;
  default:
    return kNone;
  }
  if (token > 0 && reading.kind(token - 1) == TokenKind::Dot)
    return kProperty;
  const std::string_view word = reading.text(token);
  if (ati) {
    if (fp::ati::opOf(word))
      return kFunction;
    return fp::ati::beginsStatement(word)                                   ? kKeyword
           : word.find_first_not_of("0123456789") == std::string_view::npos ? kNumber
                                                                            : kProperty;
  }
  const fp::Keyword keyword = reading.word(token).keyword;
  if (keyword == fp::Keyword::Opcode)
    return kFunction;
  if (keyword == fp::Keyword::None) {
    const auto targets = fp::reference::targets();
    const bool target = std::any_of(targets.begin(), targets.end(),
                                    [&](const auto &entry) { return entry.word == word; });
    const bool option = token > 0 && reading.word(token - 1).keyword == fp::Keyword::Option;
    return target || option ? kEnumMember : kNone;
  }
  return fp::beginsStatement(keyword) ? kKeyword : kProperty;
}

} // namespace

Json documentSymbols(const View &view) {
  const Reading reading(view.document, view.analysis);
  Json all = Json::array();
  for (const fp::Name &name : view.analysis.inspection.names.names())
    if (name.declared.end != 0)
      all.push_back(declaration(view, reading, name));
  if (view.analysis.language == fp::ir::Language::AtiFragment)
    addBlocks(view, reading, all);
  return all;
}

Json semanticLegend() {
  return {{"tokenTypes", Json(kTypes)}, {"tokenModifiers", Json(kModifiers)}};
}

namespace {

/// Encodes tokens as in the protocol, each by its distance from the previous one.
class TokenWriter {
public:
  explicit TokenWriter(const TextMap &map) : m_map(map) {}

  void add(fp::Span span, Type type, int modifiers) {
    const std::uint32_t line = m_map.lineOf(span.begin);
    const auto column = m_map.position(span.begin)["character"].get<std::int64_t>();
    for (const std::int64_t value :
         {std::int64_t(line - m_line), line == m_line ? column - m_column : column,
          std::int64_t(span.end - span.begin), std::int64_t(type), std::int64_t(modifiers)})
      m_data.push_back(value);
    m_line = line;
    m_column = column;
  }
  [[nodiscard]] Json take() { return {{"data", std::move(m_data)}}; }

private:
  const TextMap &m_map;
  Json m_data = Json::array();
  std::uint32_t m_line = 0;
  std::int64_t m_column = 0;
};

void addTokens(const View &view, TokenWriter &writer) {
  const Reading reading(view.document, view.analysis);
  const bool ati = view.analysis.language == fp::ir::Language::AtiFragment;
  const fp::NameTable &names = view.analysis.inspection.names;
  std::size_t nextUse = 0;
  for (std::size_t i = 0; i < reading.size(); ++i) {
    const fp::Span span = reading.span(i);
    while (nextUse < names.uses().size() && names.uses()[nextUse].span.begin < span.begin)
      ++nextUse;
    int modifiers = 0;
    Type type = kNone;
    if (nextUse < names.uses().size() && names.uses()[nextUse].span == span) {
      const fp::NameUse &use = names.uses()[nextUse];
      const SymbolKind kind = names.names()[use.name].kind;
      const bool constant = kind == SymbolKind::Parameter || kind == SymbolKind::ParameterArray;
      type = constant ? kParameter : kVariable;
      modifiers = (use.access == fp::Access::Declare ? kDeclaration : 0) |
                  (constant || kind == SymbolKind::Attribute ? kReadonly : 0);
    } else {
      type = typeOf(reading, i, ati);
    }
    if (type != kNone)
      writer.add(span, type, modifiers);
  }
}

} // namespace

Json semanticTokens(const Views &views) {
  TokenWriter writer(views.front().document.map());
  for (const View &view : views)
    addTokens(view, writer);
  return writer.take();
}

} // namespace arbiter::tools::lsp
