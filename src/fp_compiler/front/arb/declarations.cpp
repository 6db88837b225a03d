#include "fp_compiler/front/arb/parser.h"

namespace arbiter::fp {

namespace {
constexpr std::size_t kShownName = 40; ///< how much of a name a hint shows, in bytes
} // namespace

/// Parses <establishName>: any identifier that is not reserved. declare() reports a name that is
/// already declared, after the rest of the statement is read.
bool Parser::newName(Token &name) {
  if (!expectWord("a new name", name))
    return false;
  const bool isIndex = text(name) == "A0" && isSecondNv() && !isVertex(); // LOOP's
  if (isIndex || !isFree(name))
    error(DiagnosticId::ReservedName, name.span, quote(text(name)) + " is a reserved word",
          "choose another name");
  return true;
}

void Parser::declare(const Token &name, SymbolKind kind, std::uint16_t index) {
  if (!isFree(name))
    return;
  declareIn(m_symbols, name, Symbol{kind, index, {}, m_size}, kind);
}

/// Parses <varNameList> of TEMP or ADDRESS.
bool Parser::parseRegisters(SymbolKind kind) {
  do {
    Token name;
    if (!newName(name))
      return false;
    declare(name, kind,
            kind != SymbolKind::Address ? m_binder.temporary(text(name), name.span)
            : isNv()                    ? m_binder.addressVector(text(name), name.span)
                                        : m_binder.addressRegister(text(name), name.span));
  } while (m_tokens.accept(TokenKind::Comma));
  const std::string name(m_text.substr(m_tokens.last().begin, kShownName)
                             .substr(0, m_tokens.lastEnd() - m_tokens.last().begin));
  return endStatement("',' or ';'", at(TokenKind::Equals) && kind == SymbolKind::Temporary
                                        ? "a declaration gives no value: MOV " + name +
                                              ", ... gives one, and PARAM " + name +
                                              " = ...; is a constant"
                                        : "");
}

/// Expects the '=' of a declaration that binds a name, and tells how one is written.
bool Parser::expectBinding(const Token &name, const char *declaration, const char *binding) {
  if (m_tokens.accept(TokenKind::Equals))
    return true;
  declare(name, SymbolKind::Unknown, 0);
  return unexpected("'='", std::string("write ") + declaration + " " +
                               std::string(text(name).substr(0, kShownName)) + " = " + binding +
                               ";");
}

bool Parser::parseAttrib() {
  Token name;
  if (!newName(name) ||
      !expectBinding(name, "ATTRIB", isVertex() ? "vertex.position" : "fragment.texcoord[0]"))
    return false;
  std::uint16_t row = 0;
  const bool isBinding = keywordAt().keyword == Keyword::Attributes;
  if (atWord("vertex") && !isBinding)
    foreign(m_tokens.peek(), "a vertex attribute");
  else if (atWord("fragment") && !isBinding)
    foreign(m_tokens.peek(), "a fragment attribute");
  else if (!isBinding)
    unexpected((std::string(m_language.attributes) + ".*").c_str());
  const bool parsed = isBinding && parseAttributeBinding(Place::Declaration, row);
  declare(name, parsed ? SymbolKind::Attribute : SymbolKind::Unknown, row);
  return parsed && endStatement();
}

bool Parser::parseOutput() {
  Token name;
  if (!newName(name) || !expectBinding(name, "OUTPUT", "result.color"))
    return false;
  std::uint16_t row = 0;
  const bool isBinding = keywordAt().keyword == Keyword::Result;
  if (!isBinding)
    unexpected("result.*");
  const bool parsed = isBinding && parseResultBinding(Place::Declaration, row);
  declare(name, parsed ? SymbolKind::Output : SymbolKind::Unknown, row);
  return parsed && endStatement();
}

bool Parser::parseAlias() {
  Token name;
  if (!newName(name) || !expectBinding(name, "ALIAS", "other"))
    return false;
  Symbol symbol;
  if (!at(TokenKind::Identifier)) {
    declare(name, SymbolKind::Unknown, 0);
    return unexpected("the name of a variable");
  }
  const Token target = m_tokens.next();
  if (!isFree(target)) {
    declare(name, SymbolKind::Unknown, 0);
    error(DiagnosticId::BadAlias, target.span, quote(text(target)) + " names no variable",
          "ALIAS takes a declared name; use ATTRIB, PARAM or OUTPUT to name a binding");
    return false;
  }
  note(target, Access::Read);
  if (const Symbol *found = m_symbols.find(text(target)))
    symbol = *found;
  else
    error(DiagnosticId::BadAlias, target.span,
          "ALIAS of " + quote(text(target)) + ", which is not declared",
          m_symbols.suggest(text(target)));
  declare(name, symbol.kind, symbol.index);
  return endStatement();
}

bool Parser::parseParam() {
  Token name;
  if (!newName(name))
    return false;
  if (at(TokenKind::OpenBracket))
    return parseParamArray(name);
  bool parsed =
      m_tokens.accept(TokenKind::Equals) ||
      unexpected("'=' or '['", "write PARAM " + std::string(text(name).substr(0, kShownName)) +
                                   " = program.local[0]; or a constant behind '='");
  Rows rows;
  parsed = parsed && parseParameter(false, rows);
  const bool known = parsed && !rows.empty();
  declare(name, known ? SymbolKind::Parameter : SymbolKind::Unknown, known ? rows[0] : 0);
  return parsed && endStatement();
}

bool Parser::parseParamArray(const Token &name) {
  m_tokens.next();
  const std::size_t errorsBefore = m_reporter.errorCount();
  std::optional<std::uint32_t> size;
  Rows rows;
  bool parsed = parseArraySize(size) && expect(TokenKind::CloseBracket, "']'") &&
                expect(TokenKind::Equals, "'='") && expect(TokenKind::OpenBrace, "'{'");
  while (parsed) {
    parsed = parseArrayItem(size, rows);
    if (!parsed || !m_tokens.accept(TokenKind::Comma))
      break;
  }
  // A wrong element may stand for any number of rows, so the size is checked only without errors.
  const auto sound = [&] { return parsed && m_reporter.errorCount() == errorsBefore; };
  if (sound() && size && rows.size() < *size && at(TokenKind::CloseBrace))
    error(DiagnosticId::ArraySizeMismatch, m_tokens.peek().span,
          std::to_string(rows.size()) + " elements in an array of " + std::to_string(*size));
  parsed = parsed && expect(TokenKind::CloseBrace, "',' or '}'");
  const bool known = sound() && m_arrays.size() < kMaxArrayEntries;
  declare(name, known ? SymbolKind::ParameterArray : SymbolKind::Unknown,
          std::uint16_t(m_arrays.size()));
  if (known)
    m_arrays.push_back({std::move(rows), std::nullopt});
  return parsed && endStatement();
}

bool Parser::parseArraySize(std::optional<std::uint32_t> &size) {
  if (at(TokenKind::CloseBracket))
    return true;
  Token token;
  if (!expectInteger(token, size.emplace(), "the size of the array or ']'"))
    return false;
  const std::uint32_t limit = m_limits.api.parameters;
  const std::string message = "an array of more than " + std::to_string(limit) + " parameters";
  if (*size == 0)
    error(DiagnosticId::ArraySize, token.span, "an array of no elements");
  else if (*size > limit && m_policy == LimitPolicy::Report)
    warning(DiagnosticId::ArraySize, token.span, message);
  else if (*size > limit)
    error(DiagnosticId::ArraySize, token.span, message);
  return true;
}

bool Parser::parseArrayItem(std::optional<std::uint32_t> size, Rows &rows) {
  const Token first = m_tokens.peek();
  const std::size_t before = rows.size();
  const bool parsed = parseParameter(true, rows);
  if (size && *size != 0 && before <= *size && rows.size() > *size)
    error(DiagnosticId::ArraySizeMismatch, first.span,
          "more elements than the array's size, " + std::to_string(*size));
  m_arrayEntries += rows.size() - before;
  if (m_arrayEntries > kMaxArrayEntries) {
    error(DiagnosticId::ArrayEntries, first.span,
          "more than " + std::to_string(kMaxArrayEntries) + " elements in arrays");
    return false;
  }
  return parsed;
}

} // namespace arbiter::fp
