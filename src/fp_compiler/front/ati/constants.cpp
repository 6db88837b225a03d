#include <algorithm>

#include "fp_compiler/front/ati/parser.h"
#include "fp_compiler/front/ati/words.h"
#include "fp_compiler/front/words/numeral.h"
#include "util/suggest.h"

namespace arbiter::fp::ati {

void Parser::parseConstants() {
  if (!endStatement())
    recover();
  while (!m_reporter.full()) {
    if (acceptWord("EndConstants")) {
      if (!endStatement())
        recover();
      return;
    }
    if (m_tokens.at(TokenKind::EndOfText) || atWord("StartPrelimPass") ||
        atWord("StartOutputPass")) {
      unexpected("EndConstants", "every block of constants ends with EndConstants;");
      return;
    }
    if (!acceptWord("CONSTANT")) {
      std::string hint;
      if (m_tokens.at(TokenKind::Identifier))
        hint = didYouMean(text(m_tokens.peek()), {"CONSTANT", "EndConstants"});
      unexpected("CONSTANT or EndConstants", std::move(hint));
      // Skip at least one token, so that the loop ends.
      if (m_tokens.next().kind != TokenKind::Semicolon)
        recover();
    } else if (!parseConstant()) {
      recover();
    }
  }
}

bool Parser::parseConstant() {
  Token name;
  std::uint8_t index = 0;
  if (!parseConstantName("the name of a constant, c0 to c7", name, index))
    return false;
  if (m_declared[index])
    error(DiagnosticId::AtiConstantRedeclared, name.span,
          std::string(text(name)) + " is bound a second time", "a constant is bound at most once");
  // Declare the constant even if its binding is wrong, so that its uses give no further errors.
  m_declared[index] = true;
  if (!expect(TokenKind::Equals, "'='"))
    return false;
  Constant constant;
  const bool bound = acceptWord("program") ? parseParameterBinding(constant)
                     : m_tokens.accept(TokenKind::OpenBrace)
                         ? parseLiteral(constant)
                         : unexpected("program.env[n], program.local[n] or '{'");
  if (!bound)
    return false;
  m_shader.constants[index] = constant;
  return endStatement();
}

bool Parser::parseConstantName(const char *what, Token &token, std::uint8_t &index) {
  if (!m_tokens.at(TokenKind::Identifier))
    return unexpected(what);
  const std::optional<std::uint8_t> number = numbered(text(m_tokens.peek()), 'c');
  if (!number || *number >= kConstants)
    return unexpected(what);
  index = *number;
  token = m_tokens.next();
  note(token, Access::Declare, SymbolKind::Parameter);
  return true;
}

bool Parser::parseParameterBinding(Constant &constant) {
  if (!expect(TokenKind::Dot, "'.'"))
    return false;
  const bool env = acceptWord("env");
  if (!env && !acceptWord("local"))
    return unexpected("env or local");
  Token number;
  if (!expect(TokenKind::OpenBracket, "'['") ||
      !expectNumeral("the number of a parameter", true, number))
    return false;
  const std::uint32_t limit =
      std::min(env ? m_limits.envParameters : m_limits.localParameters, std::uint32_t(kConstants));
  const std::uint32_t index = parseInteger(text(number));
  if (index >= limit)
    error(DiagnosticId::ParameterIndex, number.span,
          "program." + std::string(env ? "env" : "local") + "[" + std::string(text(number)) +
              "]: there are " + std::to_string(limit),
          "an ATI fragment shader has the parameters 0 to 7 of each kind");
  constant.kind = env ? ConstantKind::Env : ConstantKind::Local;
  constant.index = std::uint8_t(std::min(index, limit));
  return expect(TokenKind::CloseBracket, "']'");
}

bool Parser::parseLiteral(Constant &constant) {
  constant.kind = ConstantKind::Value;
  // The specification does not define the missing components. These are the defaults of
  // ARB_vertex_program's literals.
  constant.value = {0.0f, 0.0f, 0.0f, 1.0f};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!parseNormalizedFloat(constant.value[i]))
      return false;
    if (m_tokens.accept(TokenKind::CloseBrace))
      return true;
    if (i < 3 && !expect(TokenKind::Comma, "',' or '}'"))
      return false;
  }
  return unexpected("'}'", "a constant has at most four components");
}

bool Parser::parseNormalizedFloat(float &value) {
  const std::uint32_t begin = m_tokens.peek().span.begin;
  const bool minus = m_tokens.accept(TokenKind::Minus);
  Token number;
  if (!expectNumeral("a number from 0.0 to 1.0", false, number))
    return false;
  value = parseFloat(text(number)).value;
  if (minus || value > 1.0f)
    error(DiagnosticId::AtiConstantRange, {begin, number.span.end},
          m_text.substr(begin, number.span.end - begin).size() > 48
              ? "a constant outside 0.0 to 1.0"
              : quote(m_text.substr(begin, number.span.end - begin)) + " is outside 0.0 to 1.0",
          "scale the constant, and the result with .2x, .4x or .8x");
  return true;
}

} // namespace arbiter::fp::ati
