// Parses DEFINE, DECLARE and the constants of !!FP1.0 (NV_fragment_program 3.11.2).

#include <algorithm>

#include "fp_compiler/front/native/parser.h"

namespace arbiter::fp::native {

/// Parses "DEFINE" <name> "=" <constant>.
bool NativeParser::parseDefine() {
  Token name;
  Named named;
  if (!newName(name) || !expect(TokenKind::Equals, "'='", "a constant has a value") ||
      !parseValue(named) || !endStatement())
    return false;
  declareIn(m_named, name, named, SymbolKind::Parameter);
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
  declareIn(m_named, name, named, SymbolKind::Parameter);
  m_interface.named.push_back({std::string(text(name)), named.local, named.value});
  return true;
}

/// Parses <identifier>, which may not name a register or an image unit. Words that begin statements
/// may be names, because no statement begins with a name.
bool NativeParser::newName(Token &name) {
  if (!expectWord("a new name", name))
    return false;
  const std::string_view word = text(name);
  const auto unit = numberBehind(word, "TEX");
  const bool letter = word == "f" || word == "o" || word == "p";
  if (letter || isRegisterName(word) || (unit && *unit < 16))
    error(DiagnosticId::ReservedName, name.span, quote(word) + " is a word of the language",
          "choose another name");
  return true;
}

/// Parses a vector, a number with its sign, or the name of a constant.
bool NativeParser::parseValue(Named &named) {
  named.kind = Named::Kind::Vector;
  if (at(TokenKind::OpenBrace))
    return parseVector(named.value);
  if (const Named *const known = takeNamed(Named::Kind::Vector)) {
    named.value = known->value;
    return true;
  }
  float value = 0;
  if (!parseScalar(value))
    return false;
  named.kind = Named::Kind::Scalar;
  named.value.fill(value);
  return true;
}

/// Consumes the name of a constant of that kind. Returns nullptr if another token is next.
const NativeParser::Named *NativeParser::takeNamed(Named::Kind kind) {
  const Named *const found =
      at(TokenKind::Identifier) ? m_named.find(text(m_tokens.peek())) : nullptr;
  if (!found || found->kind != kind)
    return nullptr;
  note(m_tokens.next(), Access::Read);
  return found;
}

/// Parses <scalarConstant>: a number with its sign, or the name of one.
bool NativeParser::parseScalar(float &value) {
  if (const Named *const known = takeNamed(Named::Kind::Scalar)) {
    value = known->value[0];
    return true;
  }
  if (at(TokenKind::Identifier))
    return unexpected("a number or the name of one");
  return AssemblyParser::parseScalar(value);
}

/// Parses a name as an operand: a constant, or a parameter that can be set.
bool NativeParser::parseNamed(const Token &name, Base &base) {
  note(name, Access::Read);
  const Named &named = *m_named.find(text(name));
  base.operand.file = ir::File::Parameter;
  switch (named.kind) {
  case Named::Kind::Unknown: // which was reported
    return true;
  case Named::Kind::Local:
    base.operand.index = m_binder.local(named.local, name.span);
    useParameter(base.operand, name.span);
    return true;
  case Named::Kind::Scalar:
    base.hasSuffix = false;
    base.operand.swizzle.fill(ir::Select::X); // all four are the same
    break;
  case Named::Kind::Vector:
    break;
  }
  useConstant(base.operand, named.value, name.span);
  return true;
}

} // namespace arbiter::fp::native
