#include <utility>

#include "fp_compiler/front/arb/parser.h"
#include "fp_compiler/front/words/suffix.h"

namespace arbiter::fp {

namespace {
constexpr std::uint32_t kMaxOffset = 4095;
constexpr const char *kOffsets = "offsets reach from -64 to 63; add the rest to what ARL loads";
} // namespace

bool Parser::parseOperand(nv::Statement &statement, int number) {
  if (statement.instruction.op == ir::Opcode::Swz) {
    const bool absolute = isNv() && acceptByte('|');
    if (!parseSwzSource(statement.instruction.src[0]) || (absolute && !expectByte('|')))
      return false;
    statement.absolute |= std::uint8_t(absolute);
  } else if (!AssemblyParser::parseOperand(statement, number)) {
    return false;
  }
  statement.indexed[std::size_t(number)] = std::exchange(m_indexed, {});
  return true;
}

bool Parser::parseBase(Base &base) {
  // Under NVIDIA's options a number has the same value in every component and takes no suffix.
  base.hasSuffix = !isNv() || (!at(TokenKind::Integer) && !at(TokenKind::Float));
  m_mayIndex = true;
  m_indexed.reset();
  const bool read = parseSourceRegister(base.operand);
  m_mayIndex = false;
  if (!base.hasSuffix && base.scalar)
    base.operand.swizzle.fill(ir::Select::X); // all four are the same
  return read;
}

/// Parses SWZ's operand, which is a bare <srcReg>: its components have their own signs.
bool Parser::parseSwzSource(ir::Operand &operand) {
  const std::uint32_t begin = m_tokens.peek().span.begin;
  if (at(TokenKind::Minus) || at(TokenKind::Plus)) {
    error(DiagnosticId::SwzOperand, m_tokens.peek().span, "the operand of SWZ takes no sign",
          "put the sign on the selectors: -x, -y, -z, -w");
    m_tokens.next();
  }
  if (!parseSourceRegister(operand))
    return false;
  operand.span = spanFrom(begin);
  if (at(TokenKind::Dot)) {
    error(DiagnosticId::SwzOperand, m_tokens.peek().span, "the operand of SWZ takes no suffix",
          "the four selectors behind it choose the components");
    m_tokens.next();
    if (at(TokenKind::Identifier))
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
  case Keyword::Program:
    if (!parseParameter(false, rows))
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
    return at(TokenKind::OpenBracket) ? skipIndex() : true;
  }
  if (at(TokenKind::OpenBracket)) {
    error(DiagnosticId::NotAnArray, m_tokens.peek().span, quote(text(name)) + " is no array");
    return skipIndex();
  }
  return true;
}

bool Parser::parseArrayElement(const Token &name, const Symbol &array, ir::Operand &operand) {
  const Rows &rows = m_arrays[array.index].rows;
  operand.file = ir::File::Parameter;
  operand.index = rows[0];
  if (!at(TokenKind::OpenBracket)) {
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
  if (!isFree(token))
    return unexpected("an integer or an address register");
  m_tokens.next();
  const auto address =
      addressOf(token, Access::Read, "declare one with ADDRESS and load it with ARL");
  std::uint8_t component = 0;
  if (!address || !parseAddressComponent(component) || !parseRelativeOffset(operand.offset) ||
      !expect(TokenKind::CloseBracket, "'+', '-' or ']'"))
    return false;
  Array &array = m_arrays[symbol.index];
  if (!array.relative)
    array.relative = m_binder.relativeArray(text(name), array.rows, name.span);
  operand.relative = true;
  operand.index = *array.relative;
  operand.address = std::uint8_t(*address + component);
  return true;
}

/// Returns the number of the address register of that name, or 0 after an error if it is not one.
/// Returns nothing if the statement cannot be continued.
std::optional<std::uint16_t> Parser::addressOf(const Token &name, Access access, const char *hint) {
  note(name, access);
  const Symbol *symbol = m_symbols.find(text(name));
  if (!symbol && !undeclared(name))
    return std::nullopt;
  if (symbol && symbol->kind != SymbolKind::Address && symbol->kind != SymbolKind::Unknown)
    error(DiagnosticId::AddressRegister, name.span, quote(text(name)) + " is no address register",
          hint);
  return symbol && symbol->kind == SymbolKind::Address ? symbol->index : std::uint16_t(0);
}

std::optional<std::uint16_t> Parser::takeAddress(Access access) {
  constexpr const char *kHint = "ARL writes a register declared with ADDRESS";
  const Token name = m_tokens.peek();
  if (!isFree(name)) {
    unexpected("an address register", isNv() ? "" : kHint);
    return std::nullopt;
  }
  m_tokens.next();
  return isNv() ? addressOf(name, Access::Read, "declare one with ADDRESS")
                : addressOf(name, access, kHint);
}

/// Parses <addrRegRelOffset>: -64 to 63 in the grammar, and with a warning up to Mesa's limits.
bool Parser::parseRelativeOffset(std::int16_t &offset) {
  std::optional<Offset> read;
  if (!parseOffset(read))
    return false;
  if (!read)
    return true;
  const Span where = read->token.span;
  const std::string spelled = (read->negative ? "-" : "+") + std::string(text(read->token));
  if (read->magnitude > kMaxOffset) {
    error(DiagnosticId::RelativeOffset, where, "the offset " + spelled + " is out of range",
          kOffsets);
    return true;
  }
  // Drivers accept larger offsets than the grammar, and programs use them.
  if (read->magnitude > (read->negative ? 64u : 63u))
    warning(DiagnosticId::RelativeOffset, where,
            "the offset " + spelled + " is beyond the grammar's; a driver may refuse it", kOffsets);
  offset = read->value();
  return true;
}

/// Skips "[" ... "]" after a name that has been reported.
bool Parser::skipIndex() {
  m_tokens.next();
  while (at(TokenKind::Identifier) || at(TokenKind::Integer) || at(TokenKind::Dot) ||
         at(TokenKind::Plus) || at(TokenKind::Minus)) {
    if (endsStatement(m_tokens.peek()))
      return false;
    skipped(m_tokens.next());
  }
  return expect(TokenKind::CloseBracket, "']'");
}

/// Reports a name once, and accepts it from here on. Returns false if the rest of the statement
/// cannot make sense.
bool Parser::undeclared(const Token &name) {
  const std::string_view word = text(name);
  const bool attribute = (word == "vertex" || word == "fragment") && at(TokenKind::Dot);
  if (attribute)
    foreign(name, "a " + std::string(word) + " attribute");
  else {
    const std::string hint = operandHint(name);
    error(DiagnosticId::UndeclaredName, name.span, quote(word) + " is not declared",
          hint.empty() ? m_symbols.suggest(word) : hint);
  }
  m_symbols.declare(word, {});
  if (attribute || c_like::isCall(m_text, name.span))
    return false;
  return at(TokenKind::OpenBracket) ? skipIndex() : true;
}

/// Returns the hint for a suffix that is wrong: what it is in four components, if it is GLSL's.
std::string Parser::suffixHint(std::string_view suffix, bool scalar) const {
  ir::Swizzle ignored = ir::kIdentity;
  const std::string four = scalar ? "" : c_like::fourComponents(suffix);
  std::string hint = AssemblyParser::suffixHint(suffix, scalar);
  if (four.empty() || readSwizzle(four, m_language.colorLetters, false, ignored))
    return hint;
  return hint + ": write ." + four;
}

} // namespace arbiter::fp
