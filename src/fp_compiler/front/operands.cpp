#include "fp_compiler/front/c_like/statements.h"
#include "fp_compiler/front/parser.h"
#include "fp_compiler/front/words/numeral.h"
#include "fp_compiler/front/words/suffix.h"

namespace arbiter::fp {

namespace {
constexpr std::uint32_t kMaxOffset = 4095;
} // namespace

/// Parses <vectorSrcReg>, or <scalarSrcReg>, whose component is repeated.
bool Parser::parseSource(bool scalar, ir::Operand &operand) {
  const std::uint32_t begin = m_tokens.peek().span.begin;
  if (m_tokens.at(TokenKind::Minus))
    operand.negate = 0xF;
  if (m_tokens.at(TokenKind::Minus) || m_tokens.at(TokenKind::Plus))
    m_tokens.next();
  if (!parseSourceRegister(operand) || !parseSwizzle(scalar, operand.swizzle, begin))
    return false;
  operand.span = spanFrom(begin);
  return true;
}

/// Parses SWZ's operand, which is a bare <srcReg>: its components have their own signs.
bool Parser::parseSwzSource(ir::Operand &operand) {
  const std::uint32_t begin = m_tokens.peek().span.begin;
  if (m_tokens.at(TokenKind::Minus) || m_tokens.at(TokenKind::Plus)) {
    error(DiagnosticId::SwzOperand, m_tokens.peek().span, "the operand of SWZ takes no sign",
          "put the sign on the selectors: -x, -y, -z, -w");
    m_tokens.next();
  }
  if (!parseSourceRegister(operand))
    return false;
  operand.span = spanFrom(begin);
  if (m_tokens.at(TokenKind::Dot)) {
    error(DiagnosticId::SwzOperand, m_tokens.peek().span, "the operand of SWZ takes no suffix",
          "the four selectors behind it choose the components");
    m_tokens.next();
    if (m_tokens.at(TokenKind::Identifier))
      m_tokens.next();
  }
  return true;
}

/// Parses <srcReg>.
bool Parser::parseSourceRegister(ir::Operand &operand) {
  const Token first = m_tokens.peek();
  if (first.kind == TokenKind::OpenBrace || first.kind == TokenKind::Integer ||
      first.kind == TokenKind::Float) {
    operand.file = ir::File::Parameter;
    return parseConstant(false, operand.index);
  }
  if (first.kind != TokenKind::Identifier)
    return unexpected("an operand");
  Rows rows;
  switch (keywordAt().keyword) {
  case Keyword::None:
    return parseNamedSource(operand);
  case Keyword::Attributes:
    operand.file = ir::File::Attribute;
    return parseAttributeBinding(Place::Operand, operand.index);
  case Keyword::State:
    m_tokens.next();
    if (!parseStateBinding(first.span.begin, false, rows))
      return false;
    break;
  case Keyword::Program:
    m_tokens.next();
    if (!parseProgramBinding(first.span.begin, false, rows))
      return false;
    break;
  case Keyword::Result:
    error(DiagnosticId::WriteOnly, first.span, "a result cannot be read",
          "compute in a temporary and move it to the result");
    return parseResultBinding(Place::Operand, operand.index);
  case Keyword::Texture:
    return unexpected("an operand", "the coordinate stands before the unit: TEX " +
                                        shownPart(parts(), 0, "dst") + ", " +
                                        shownPart(parts(), 2, "coord") + ", texture[0], 2D;");
  default:
    return unexpected("an operand");
  }
  operand.file = ir::File::Parameter;
  operand.index = rows[0];
  return true;
}

bool Parser::parseNamedSource(ir::Operand &operand) {
  const Token name = m_tokens.next();
  note(name, Access::Read);
  const Symbol *symbol = m_symbols.find(text(name));
  if (!symbol)
    return undeclared(name);
  operand.index = symbol->index;
  switch (symbol->kind) {
  case SymbolKind::Temporary:
    operand.file = ir::File::Temporary;
    break;
  case SymbolKind::Attribute:
    operand.file = ir::File::Attribute;
    break;
  case SymbolKind::Parameter:
    operand.file = ir::File::Parameter;
    break;
  case SymbolKind::ParameterArray:
    return parseArrayElement(name, *symbol, operand);
  case SymbolKind::Output:
    error(DiagnosticId::WriteOnly, name.span, "the result " + quote(text(name)) + " cannot be read",
          "compute in a temporary and move it to the result");
    return true;
  case SymbolKind::Address:
    error(DiagnosticId::AddressRegister, name.span,
          "the address register " + quote(text(name)) + " is no operand",
          "only the index of an array reads it: c[" + std::string(text(name).substr(0, 40)) +
              ".x]");
    operand.index = 0;
    return true;
  case SymbolKind::Unknown:
    return m_tokens.at(TokenKind::OpenBracket) ? skipIndex() : true;
  }
  if (m_tokens.at(TokenKind::OpenBracket)) {
    error(DiagnosticId::NotAnArray, m_tokens.peek().span, quote(text(name)) + " is no array");
    return skipIndex();
  }
  return true;
}

bool Parser::parseArrayElement(const Token &name, const Symbol &array, ir::Operand &operand) {
  const Rows &rows = m_arrays[array.index].rows;
  operand.file = ir::File::Parameter;
  operand.index = rows[0];
  if (!m_tokens.at(TokenKind::OpenBracket)) {
    const Token token = m_tokens.peek();
    error(DiagnosticId::ArrayNotIndexed, token.span,
          "the array " + quote(text(name)) + " needs an index",
          "write " + quote(std::string(text(name).substr(0, 40)) + "[0]"));
    return true;
  }
  if (m_language.addresses && m_tokens.peek(1).kind == TokenKind::Identifier)
    return parseRelativeElement(name, array, operand);
  std::uint32_t index = 0;
  if (!parseIndex(std::uint32_t(rows.size()), DiagnosticId::ArrayIndex, "array index", index))
    return false;
  operand.index = rows[index];
  return true;
}

/// Parses "[" <progParamArrayRel> "]".
bool Parser::parseRelativeElement(const Token &name, const Symbol &symbol, ir::Operand &operand) {
  m_tokens.next();
  const Token token = m_tokens.peek();
  if (keywordAt().keyword != Keyword::None)
    return unexpected("an integer or an address register");
  m_tokens.next();
  note(token, Access::Read);
  const Symbol *address = m_symbols.find(text(token));
  if (!address && !undeclared(token))
    return false;
  if (address && address->kind != SymbolKind::Address && address->kind != SymbolKind::Unknown)
    error(DiagnosticId::AddressRegister, token.span, quote(text(token)) + " is no address register",
          "declare one with ADDRESS and load it with ARL");
  if (!parseAddressComponent() || !parseRelativeOffset(operand.offset) ||
      !expect(TokenKind::CloseBracket, "'+', '-' or ']'"))
    return false;
  Array &array = m_arrays[symbol.index];
  if (!array.relative)
    array.relative = m_binder.relativeArray(text(name), array.rows, name.span);
  operand.relative = true;
  operand.index = *array.relative;
  operand.address = std::uint8_t((address ? address->index : 0) + m_addressComponent);
  return true;
}

/// Parses <addrComponent> or <addrWriteMask>.
bool Parser::parseAddressComponent() {
  constexpr const char *kHint = "an address register has the component x only";
  if (!expect(TokenKind::Dot, "'.x'", kHint))
    return false;
  if (!m_tokens.at(TokenKind::Identifier))
    return unexpected("'x'", kHint);
  const Token token = m_tokens.next();
  m_addressComponent = 0;
  if (const auto component = std::string_view("xyzw").find(text(token));
      m_options.nv != ir::NvOption::None && text(token).size() == 1 && component < 4)
    m_addressComponent = std::uint8_t(component);
  else if (text(token) != "x")
    error(DiagnosticId::AddressComponent, token.span,
          "an address register has no component " + quote(text(token)), "write .x");
  return true;
}

/// Parses <addrRegRelOffset>: -64 to 63 in the grammar, and with a warning up to Mesa's limits.
bool Parser::parseRelativeOffset(std::int16_t &offset) {
  const bool negative = m_tokens.at(TokenKind::Minus);
  if (!negative && !m_tokens.at(TokenKind::Plus))
    return true;
  m_tokens.next();
  if (!m_tokens.at(TokenKind::Integer))
    return unexpected("an integer");
  const Token token = m_tokens.next();
  const std::uint32_t value = parseInteger(text(token));
  const std::string spelled = (negative ? "-" : "+") + std::string(text(token));
  if (value > kMaxOffset) {
    error(DiagnosticId::RelativeOffset, token.span, "the offset " + spelled + " is out of range",
          "offsets reach from -64 to 63; add the rest to what ARL loads");
    return true;
  }
  // Drivers accept larger offsets than the grammar, and programs use them.
  if (value > (negative ? 64u : 63u))
    m_reporter.warning(DiagnosticId::RelativeOffset, token.span,
                       "the offset " + spelled + " is beyond the grammar's; a driver may refuse it",
                       "offsets reach from -64 to 63; add the rest to what ARL loads");
  offset = std::int16_t(negative ? -std::int32_t(value) : std::int32_t(value));
  return true;
}

/// Skips "[" ... "]" after a name that has been reported.
bool Parser::skipIndex() {
  m_tokens.next();
  while (m_tokens.at(TokenKind::Identifier) || m_tokens.at(TokenKind::Integer) ||
         m_tokens.at(TokenKind::Dot) || m_tokens.at(TokenKind::Plus) ||
         m_tokens.at(TokenKind::Minus)) {
    if (beginsStatement(keywordAt().keyword))
      return false;
    noteSkipped(m_tokens.next());
  }
  return expect(TokenKind::CloseBracket, "']'");
}

/// Reports a name once, and accepts it from here on. Returns false if the rest of the statement
/// cannot make sense.
bool Parser::undeclared(const Token &name) {
  const std::string_view word = text(name);
  const bool attribute = (word == "vertex" || word == "fragment") && m_tokens.at(TokenKind::Dot);
  if (attribute)
    foreign(name, "a " + std::string(word) + " attribute");
  else {
    const std::string hint = c_like::operandHint(
        m_text, name.span, c_like::dialectOf(m_language.language), vocabulary());
    error(DiagnosticId::UndeclaredName, name.span, quote(word) + " is not declared",
          hint.empty() ? m_symbols.suggest(word) : hint);
  }
  m_symbols.declare(word, {});
  if (attribute || c_like::isCall(m_text, name.span))
    return false;
  return m_tokens.at(TokenKind::OpenBracket) ? skipIndex() : true;
}

/// Parses <optionalSuffix> or <scalarSuffix>, with its dot.
/// \param begin of a scalar operand, for the hint
bool Parser::parseSwizzle(bool scalar, ir::Swizzle &swizzle, std::uint32_t begin) {
  if (!m_tokens.at(TokenKind::Dot)) {
    if (scalar)
      error(DiagnosticId::ScalarSuffix, m_tokens.peek().span,
            "this operand is a scalar and needs one component",
            componentHint(m_text.substr(begin, m_tokens.lastEnd() - begin)));
    return true;
  }
  m_tokens.next();
  if (!m_tokens.at(TokenKind::Identifier))
    return unexpected("a component");
  const Token token = m_tokens.next();
  const SuffixError wrong = readSwizzle(text(token), m_language.colorLetters, scalar, swizzle);
  if (wrong)
    error(scalar ? DiagnosticId::ScalarSuffix : DiagnosticId::BadSwizzle,
          {token.span.begin + wrong.offset, token.span.end},
          "bad suffix " + quote(text(token)) + ": " + wrong.reason,
          suffixHint(text(token), scalar));
  return true;
}

/// Returns the hint for a suffix that is wrong: what it is in four components, if it is GLSL's.
std::string Parser::suffixHint(std::string_view suffix, bool scalar) const {
  ir::Swizzle ignored = ir::kIdentity;
  const std::string four = scalar ? "" : c_like::fourComponents(suffix);
  std::string hint =
      scalar ? "a scalar operand takes one of x, y, z, w" : "a suffix is one or four of x, y, z, w";
  if (m_language.colorLetters)
    hint += scalar ? " or r, g, b, a" : ", or of r, g, b, a";
  if (four.empty() || readSwizzle(four, m_language.colorLetters, false, ignored))
    return hint;
  return hint + ": write ." + four;
}

} // namespace arbiter::fp
