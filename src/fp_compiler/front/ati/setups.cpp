#include "fp_compiler/front/ati/parser.h"
#include "fp_compiler/front/ati/words.h"
#include "util/suggest.h"

namespace arbiter::fp::ati {

bool Parser::parseSetup(const Token &first, SetupKind kind) {
  Token name;
  std::uint8_t index = 0;
  if (!parseRegister("a register, r0 to r5", name, index))
    return false;
  if (m_pass->setups[index].kind != SetupKind::None)
    error(DiagnosticId::AtiSetupTwice, name.span,
          std::string(text(name)) + " is set up a second time in this pass",
          "PassTexCoord and SampleMap write a register once in a pass");
  // The printed grammar lacks the comma, but the examples have it.
  m_tokens.accept(TokenKind::Comma);
  Setup setup;
  setup.kind = kind;
  if (!parseSetupSource(setup))
    return false;
  setup.span = {first.span.begin, m_tokens.lastEnd()};
  m_pass->setups[index] = setup;
  return endStatement();
}

bool Parser::isRegister(const Token &token, Access access, std::uint8_t &index) {
  const std::optional<std::uint8_t> number = numbered(text(token), 'r');
  if (!number)
    return false;
  note(token, access);
  if (*number >= kRegisters) {
    error(DiagnosticId::AtiRegister, token.span, "no register " + quote(text(token)),
          "the registers are r0 to r5");
    index = 0;
    return true;
  }
  index = *number;
  m_registersUsed[index] = true;
  // GL_MAX_TEXTURE_UNITS counts units of fixed function alone; NVIDIA's drivers have four of them.
  if (index >= m_limits.textureImageUnits)
    error(DiagnosticId::AtiRegisterUnit, token.span,
          std::string(text(token)) + " has no texture unit of its number: there are " +
              std::to_string(m_limits.textureImageUnits),
          "use a register below that number");
  return true;
}

bool Parser::parseRegister(const char *what, Token &token, std::uint8_t &index) {
  if (!m_tokens.at(TokenKind::Identifier))
    return unexpected(what);
  token = m_tokens.peek();
  if (!isRegister(token, Access::Write, index))
    return unexpected(what);
  m_tokens.next();
  return true;
}

bool Parser::parseSetupSource(Setup &setup) {
  constexpr const char *kWhat = "a texture coordinate set, t0 to t5, or a register";
  if (!m_tokens.at(TokenKind::Identifier))
    return unexpected(kWhat);
  const Token source = m_tokens.peek();
  setup.fromRegister = isRegister(source, Access::Read, setup.source);
  if (setup.fromRegister) {
    if (m_shader.passCount == 1)
      error(DiagnosticId::AtiRegisterSource, source.span,
            std::string(text(source)) + " as the source of a setup in the first pass",
            "registers hold nothing before the first pass; name a texture coordinate set");
  } else {
    const std::optional<std::uint8_t> number = numbered(text(source), 't');
    if (!number)
      return unexpected(kWhat);
    constexpr std::uint8_t kNamed = 6; // of the grammar: t0 to t5
    const std::uint32_t limit = std::min<std::uint32_t>(m_limits.textureCoords, kNamed);
    if (*number >= limit)
      error(DiagnosticId::TexCoordIndex, source.span,
            "no texture coordinate set " + quote(text(source)) + ": there are " +
                std::to_string(limit),
            "the sets are t0 to t5, as far as there are such sets");
    setup.source = *number < kTexCoords ? *number : 0;
  }
  m_tokens.next();
  return parseCoordinates(setup, source);
}

bool Parser::parseCoordinates(Setup &setup, const Token &source) {
  constexpr const char *kWhat = ".str, .stq, .str_dr or .stq_dq";
  Token selector;
  if (!expect(TokenKind::Dot, kWhat, "say which three components to take") ||
      !expectWord(kWhat, selector))
    return false;
  const std::optional<Coordinates> coordinates = coordinatesOf(text(selector));
  if (!coordinates) {
    error(DiagnosticId::AtiCoordinates, selector.span,
          "no choice of components " + quote(text(selector)),
          didYouMean(text(selector), {"str", "stq", "str_dr", "stq_dq"},
                     "write .str, .stq, .str_dr or .stq_dq"));
    return true;
  }
  setup.coordinates = *coordinates;
  const bool q = setup.coordinates == Coordinates::Stq || setup.coordinates == Coordinates::StqDq;
  if (!setup.fromRegister)
    useTexCoord(setup, source, selector);
  else if (q)
    error(DiagnosticId::AtiRegisterCoordinates, selector.span,
          "'" + std::string(text(selector)) + "' of a register",
          "a register has str and str_dr only");
  return true;
}

void Parser::useTexCoord(const Setup &setup, const Token &source, const Token &selector) {
  const bool q = setup.coordinates == Coordinates::Stq || setup.coordinates == Coordinates::StqDq;
  Third &third = m_thirds[setup.source];
  const Third wanted = q ? Third::Q : Third::R;
  if (third != Third::Unused && third != wanted)
    error(DiagnosticId::AtiCoordinateConflict, selector.span,
          std::string(text(source)) + " with '" + std::string(text(selector)) +
              "' after a use with " + (q ? "str" : "stq"),
          "a texture coordinate set gives either r or q to the whole program");
  else
    third = wanted;
}

} // namespace arbiter::fp::ati
