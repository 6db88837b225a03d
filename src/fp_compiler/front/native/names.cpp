// Parses DEFINE, DECLARE and the constants of !!FP1.0 (NV_fragment_program 3.11.2).

#include <algorithm>

#include "fp_compiler/front/native/parser.h"
#include "fp_compiler/front/words/numeral.h"

namespace arbiter::fp::native {

/// Parses "DEFINE" <name> "=" <constant>.
bool NativeParser::parseDefine() {
  Token name;
  Named named;
  if (!newName(name) || !expect(TokenKind::Equals, "'='", "a constant has a value") ||
      !parseValue(named) || !endStatement())
    return false;
  declare(name, named);
  m_interface.constants.emplace_back(text(name));
  return true;
}

/// Parses "DECLARE" <name>, and optionally "=" <constant>. The default is (0,0,0,0).
bool NativeParser::parseDeclare() {
  Token name;
  Named named;
  if (!newName(name) || (m_tokens.accept(TokenKind::Equals) && !parseValue(named)) ||
      !endStatement("'=' or ';'"))
    return false;
  named.kind = Named::Kind::Local;
  const std::size_t number = m_interface.named.size();
  if (number >= kMaxNamedParameters) {
    error(DiagnosticId::LimitParameters, name.span,
          "more than " + std::to_string(kMaxNamedParameters) + " named parameters",
          "use numbered ones, p[n], too");
    return true;
  }
  named.local = std::uint16_t(std::min(m_limits.localParameters, kMaxLocals) + number);
  declare(name, named);
  m_interface.named.push_back({std::string(text(name)), named.local, named.value});
  return true;
}

/// Parses <identifier>, which may not name a register or an image unit. Words that begin statements
/// may be names, because no statement begins with a name.
bool NativeParser::newName(Token &name) {
  if (!m_tokens.at(TokenKind::Identifier))
    return unexpected("a new name");
  name = m_tokens.next();
  const std::string_view word = text(name);
  const auto unit = numberBehind(word, "TEX");
  const bool letter = word == "f" || word == "o" || word == "p";
  if (letter || isRegisterName(word) || (unit && *unit < 16))
    error(DiagnosticId::ReservedName, name.span, quote(word) + " is a word of the language",
          "choose another name");
  return true;
}

void NativeParser::declare(const Token &name, const Named &named) {
  note(name, Access::Declare, SymbolKind::Parameter);
  Named &known = m_named[text(name)];
  if (known.kind != Named::Kind::Unknown)
    return error(DiagnosticId::RedeclaredName, name.span, quote(text(name)) + " is declared twice",
                 "the first declaration is in line " +
                     std::to_string(locate(m_text, known.declared.begin).line));
  known = named;
  known.declared = name.span;
}

/// Parses a vector, a number with its sign, or the name of a constant.
bool NativeParser::parseValue(Named &named) {
  named.kind = Named::Kind::Vector;
  if (m_tokens.at(TokenKind::OpenBrace))
    return parseVector(named.value);
  if (m_tokens.at(TokenKind::Identifier)) {
    const auto found = m_named.find(text(m_tokens.peek()));
    if (found != m_named.end() && found->second.kind == Named::Kind::Vector) {
      note(m_tokens.next(), Access::Read);
      named.value = found->second.value;
      return true;
    }
  }
  float value = 0;
  if (!parseScalar(value))
    return false;
  named.kind = Named::Kind::Scalar;
  named.value.fill(value);
  return true;
}

/// Parses <vectorConstant>. Missing y, z and w are 0, 0 and 1.
bool NativeParser::parseVector(ir::Vec4 &value) {
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

/// Parses <scalarConstant>: a number with its sign, or the name of one.
bool NativeParser::parseScalar(float &value) {
  if (m_tokens.at(TokenKind::Identifier)) {
    const Token name = m_tokens.peek();
    const auto found = m_named.find(text(name));
    if (found == m_named.end() || found->second.kind != Named::Kind::Scalar)
      return unexpected("a number or the name of one");
    note(m_tokens.next(), Access::Read);
    value = found->second.value[0];
    return true;
  }
  const bool negative = m_tokens.at(TokenKind::Minus);
  if (negative || m_tokens.at(TokenKind::Plus))
    m_tokens.next();
  if (!parseNumber(value))
    return false;
  value = negative ? -value : value;
  return true;
}

/// Parses <floatConstant>. An integer is accepted too.
bool NativeParser::parseNumber(float &value) {
  if (!m_tokens.at(TokenKind::Integer) && !m_tokens.at(TokenKind::Float))
    return unexpected("a number");
  const Token token = m_tokens.next();
  const FloatValue parsed = parseFloat(text(token));
  if (parsed.overflow)
    m_reporter.warning(DiagnosticId::NumeralOverflow, token.span,
                       quote(text(token)) + " is beyond the largest float, which is used instead");
  value = parsed.value;
  return true;
}

/// Parses a name as an operand: a constant, or a parameter that can be set.
bool NativeParser::parseNamed(const Token &name, ir::Operand &operand, bool &hasSuffix) {
  note(name, Access::Read);
  const Named &named = m_named.at(text(name));
  operand.file = ir::File::Parameter;
  switch (named.kind) {
  case Named::Kind::Unknown: // which was reported
    return true;
  case Named::Kind::Local:
    operand.index = m_binder.local(named.local, name.span);
    useParameter(operand, name.span);
    return true;
  case Named::Kind::Scalar:
    hasSuffix = false;
    operand.swizzle.fill(ir::Select::X); // all four are the same
    break;
  case Named::Kind::Vector:
    break;
  }
  operand.index = m_binder.constant(named.value, name.span);
  useConstant(named.value, name.span);
  return true;
}

/// Parses a number as an operand. It sets every component.
bool NativeParser::parseLiteral(bool negative, ir::Operand &operand) {
  const std::uint32_t begin = m_tokens.peek().span.begin;
  ir::Vec4 value = {};
  if (!parseNumber(value[0]))
    return false;
  value.fill(negative ? -value[0] : value[0]);
  operand.file = ir::File::Parameter;
  operand.index = m_binder.constant(value, spanFrom(begin));
  operand.swizzle.fill(ir::Select::X);
  useConstant(value, spanFrom(begin));
  return true;
}

} // namespace arbiter::fp::native
