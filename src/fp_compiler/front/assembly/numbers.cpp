// Parses indices and constants.

#include "fp_compiler/front/assembly/parser.h"
#include "fp_compiler/front/words/numeral.h"

namespace arbiter::fp {

bool AssemblyParser::expectInteger(Token &token, std::uint32_t &value, const char *what) {
  token = m_tokens.peek();
  if (!expect(TokenKind::Integer, what))
    return false;
  value = parseInteger(text(token));
  return true;
}

/// Parses "[" <integer> "]".
bool AssemblyParser::parseIndex(std::uint32_t limit, DiagnosticId id, const char *what,
                                std::uint32_t &index) {
  return expect(TokenKind::OpenBracket, "'['") && parseBounded(limit, id, what, index) &&
         expect(TokenKind::CloseBracket, "']'");
}

/// Parses the offset from an address register, if there is one.
bool AssemblyParser::parseOffset(std::optional<Offset> &offset) {
  if (!at(TokenKind::Minus) && !at(TokenKind::Plus))
    return true;
  offset.emplace().negative = acceptSign();
  return expectInteger(offset->token, offset->magnitude);
}

/// Parses <floatConstant>. An integer is accepted too, as programs use it.
bool AssemblyParser::parseNumber(float &value) {
  if (!at(TokenKind::Integer) && !at(TokenKind::Float))
    return unexpected("a number");
  const Token token = m_tokens.next();
  const FloatValue parsed = parseFloat(text(token));
  if (parsed.overflow)
    warning(DiagnosticId::NumeralOverflow, token.span,
            quote(text(token)) + " is beyond the largest float, which is used instead");
  value = parsed.value;
  return true;
}

bool AssemblyParser::parseScalar(float &value) {
  const bool negative = acceptSign();
  if (!parseNumber(value))
    return false;
  value = negative ? -value : value;
  return true;
}

/// Parses a vector in braces. Missing y, z and w are 0, 0 and 1.
bool AssemblyParser::parseVector(ir::Vec4 &value) {
  m_tokens.next();
  value = {0, 0, 0, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!parseScalar(value[i]))
      return false;
    if (i == 3 || !m_tokens.accept(TokenKind::Comma))
      break;
  }
  return expect(TokenKind::CloseBrace, "'}'", "a vector has one to four components");
}

} // namespace arbiter::fp
