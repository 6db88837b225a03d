#include <algorithm>

#include "fp_compiler/front/arb/parser.h"
#include "util/suggest.h"

namespace arbiter::fp {

/// Reports that the current token is not one of the words that are allowed here.
bool Parser::unknownWord(const char *what, const std::vector<std::string_view> &words,
                         const std::vector<std::string_view> &foreignWords) {
  if (!at(TokenKind::Identifier))
    return unexpected(what);
  const std::string_view word = text(m_tokens.peek());
  if (std::find(foreignWords.begin(), foreignWords.end(), word) != foreignWords.end()) {
    foreign(m_tokens.peek(), quote(word));
    return false;
  }
  std::string list;
  for (std::string_view candidate : words)
    (list += list.empty() ? "one of " : ", ") += candidate;
  error(DiagnosticId::UnknownBinding, m_tokens.peek().span,
        "expected " + std::string(what) + ", found " + quote(word),
        didYouMean(word, words, std::move(list)));
  return false;
}

/// Parses <integer> from 0 to limit - 1. A value out of range is not a syntax error; it becomes 0.
bool Parser::parseBounded(std::uint32_t limit, DiagnosticId id, const char *what,
                          std::uint32_t &value) {
  if (at(TokenKind::Identifier)) {
    error(DiagnosticId::RelativeAddressing, m_tokens.peek().span,
          "the index " + quote(text(m_tokens.peek())) + " is no constant",
          m_language.addresses ? "a register indexes only the arrays that PARAM declares"
                               : "only vertex programs index by a register; unroll the access");
    return false;
  }
  Token token;
  if (!expectInteger(token, value))
    return false;
  if (value < limit)
    return true;
  value = 0;
  error(id, token.span, std::string(what) + " " + quote(text(token)) + " is out of range",
        limit == 0 ? "there is none here" : "the largest is " + std::to_string(limit - 1));
  return true;
}

bool Parser::parseOptionalIndex(std::uint32_t limit, DiagnosticId id, const char *what,
                                std::uint32_t &index) {
  index = 0;
  return !at(TokenKind::OpenBracket) || parseIndex(limit, id, what, index);
}

/// Parses "[" <integer> and, in an array, ".." <integer>. After an error the range is one row.
bool Parser::parseRange(std::uint32_t limit, DiagnosticId id, const char *what, bool range,
                        std::uint32_t &first, std::uint32_t &last) {
  const std::size_t errorsBefore = m_reporter.errorCount();
  if (!expect(TokenKind::OpenBracket, "'['") || !parseBounded(limit, id, what, first))
    return false;
  last = first;
  if (range && m_tokens.accept(TokenKind::DotDot)) {
    const Token token = m_tokens.peek();
    if (!parseBounded(limit, id, what, last))
      return false;
    if (last < first && m_reporter.errorCount() == errorsBefore)
      error(DiagnosticId::ReversedRange, token.span, "the range runs backwards");
  }
  if (m_reporter.errorCount() != errorsBefore)
    last = first;
  return true;
}

/// Parses what a PARAM or an operand binds: state, program parameters, or a constant.
bool Parser::parseParameter(bool range, Rows &rows) {
  const std::uint32_t begin = m_tokens.peek().span.begin;
  switch (keywordAt().keyword) {
  case Keyword::State:
    m_tokens.next();
    return parseStateBinding(begin, range, rows);
  case Keyword::Program:
    m_tokens.next();
    return parseProgramBinding(begin, range, rows);
  default:
    std::uint16_t row = 0;
    if (!parseConstant(true, row))
      return false;
    rows.push_back(row);
    return true;
  }
}

/// Parses <fragAttribBinding> or <vtxAttribBinding>, from its first word on.
bool Parser::parseAttributeBinding(Place place, std::uint16_t &row) {
  const std::uint32_t begin = m_tokens.next().span.begin;
  const bool vertex = isVertex();
  if (!expect(TokenKind::Dot, "'.'",
              vertex ? "name the attribute: vertex.position, vertex.color, vertex.texcoord[0]"
                     : "name the attribute: fragment.color, fragment.texcoord[0]"))
    return false;
  ir::Attribute attribute;
  if (atWord("color")) {
    if (!parseColorAttribute(place, attribute))
      return false;
  } else if (atWord("texcoord")) {
    attribute.kind = ir::AttributeKind::TexCoord;
    m_tokens.next();
    if (atAddress()) {
      if (!parseIndexedAttribute(m_texCoords, attribute.kind, m_limits.textureCoords))
        return false;
      row = m_sequences[*m_texCoords].front();
      return true;
    }
    if (!parseTexCoord(attribute.index))
      return false;
  } else if (atWord("fogcoord") || atWord("position")) {
    attribute.kind = text(m_tokens.next()) == "fogcoord" ? ir::AttributeKind::FogCoord
                                                         : ir::AttributeKind::Position;
  } else if (!vertex && isSecondNv() && acceptWord("facing")) {
    attribute.kind = ir::AttributeKind::Facing;
  } else if (vertex) {
    if (!parseVertexAttribute(attribute))
      return false;
  } else {
    return unknownWord("a fragment attribute", {"color", "texcoord", "fogcoord", "position"},
                       {"normal", "weight", "matrixindex", "attrib"});
  }
  row = m_binder.attribute(attribute, spanFrom(begin));
  return true;
}

/// Parses an index by an address register, which chooses from all attributes of a kind.
bool Parser::parseIndexedAttribute(std::optional<std::uint16_t> &sequence, ir::AttributeKind kind,
                                   std::uint32_t count) {
  const Span where = m_tokens.peek().span;
  return parseIndexed(sequence, count, [&](std::uint8_t index) {
    return m_binder.attribute({kind, index}, where, false);
  });
}

/// Parses "color" <optColorType>.
bool Parser::parseColorAttribute(Place place, ir::Attribute &attribute) {
  m_tokens.next();
  const bool secondary = atWord("secondary", 1);
  if (at(TokenKind::Dot) && (secondary || atWord("primary", 1))) {
    m_tokens.next();
    m_tokens.next();
    attribute.kind =
        secondary ? ir::AttributeKind::ColorSecondary : ir::AttributeKind::ColorPrimary;
  } else if (at(TokenKind::Dot) && place == Place::Declaration) {
    m_tokens.next();
    return unknownWord("primary or secondary", {"primary", "secondary"});
  }
  return true;
}

/// Parses <optTexCoordNum>.
bool Parser::parseTexCoord(std::uint8_t &index) {
  std::uint32_t parsed = 0;
  if (!parseOptionalIndex(byteLimit(m_limits.textureCoords), DiagnosticId::TexCoordIndex,
                          "texture coordinate set", parsed))
    return false;
  index = std::uint8_t(parsed);
  return true;
}

/// Parses <resultBinding>, from "result" on.
bool Parser::parseResultBinding(Place place, std::uint16_t &row) {
  m_tokens.next();
  const bool vertex = isVertex();
  if (!expect(TokenKind::Dot, "'.'",
              vertex ? "name the result: result.position, result.color, result.texcoord[0]"
                     : "name the result: result.color or result.depth"))
    return false;
  ir::Output output;
  if (!(vertex ? parseVertexResult(output) : parseFragmentResult(output)))
    return false;
  if (place == Place::Declaration && at(TokenKind::Dot))
    return unexpected("';'", "the mask goes to the instruction that writes the variable");
  row = m_binder.output(output);
  return true;
}

/// Parses <resultBinding> of fragment programs, after its dot.
bool Parser::parseFragmentResult(ir::Output &output) {
  if (acceptWord("depth")) {
    output.kind = ir::OutputKind::Depth;
    return true;
  }
  if (!acceptWord("color"))
    return unknownWord("a fragment result", {"color", "depth"},
                       {"position", "fogcoord", "pointsize", "texcoord", "clip"});
  if (at(TokenKind::OpenBracket)) {
    std::uint32_t index = 0;
    if (!m_options.drawBuffers)
      error(DiagnosticId::ColorOption, m_tokens.peek().span,
            "result.color[n] needs a program option", "add OPTION ARB_draw_buffers;");
    if (!parseIndex(byteLimit(m_limits.drawBuffers), DiagnosticId::ColorIndex, "draw buffer",
                    index))
      return false;
    output.index = std::uint8_t(index);
  } else if (at(TokenKind::Dot) && m_tokens.peek(1).kind == TokenKind::Identifier) {
    const Token word = m_tokens.peek(1);
    const std::string_view side = text(word);
    if (side == "primary" || side == "secondary" || side == "front" || side == "back") {
      foreign(word, "result.color." + std::string(side));
      return false;
    }
  }
  return true;
}

/// Parses <programSingleItem> or <programMultipleItem>, after "program".
bool Parser::parseProgramBinding(std::uint32_t begin, bool range, Rows &rows) {
  if (!expect(TokenKind::Dot, "'.'", "name the parameter: program.local[0] or program.env[0]"))
    return false;
  const bool env = acceptWord("env");
  if (!env && !acceptWord("local"))
    return unknownWord("env or local", {"env", "local"});
  const std::uint32_t limit =
      std::min(env ? m_limits.envParameters : m_limits.localParameters, 65536u);
  const char *what = env ? "environment parameter" : "local parameter";
  const std::size_t errorsBefore = m_reporter.errorCount();
  std::uint32_t first = 0, last = 0;
  if (!parseRange(limit, DiagnosticId::ParameterIndex, what, range, first, last) ||
      !expect(TokenKind::CloseBracket, "']'",
              range ? "" : "a range belongs in an array: PARAM p[] = { program.local[0..3] }"))
    return false;
  // If the index is out of range, one row stands for the binding, so that the statement is still
  // checked.
  if (m_reporter.errorCount() != errorsBefore)
    first = last = 0;
  for (std::uint32_t i = first; i <= last; ++i)
    rows.push_back(env ? m_binder.env(i, spanFrom(begin)) : m_binder.local(i, spanFrom(begin)));
  return true;
}

/// Parses <paramConstDecl> (signed) or <paramConstUse>. A scalar sets all four components.
bool Parser::parseConstant(bool isSigned, std::uint16_t &row) {
  const std::uint32_t begin = m_tokens.peek().span.begin;
  ir::Vec4 value{};
  if (at(TokenKind::OpenBrace)) {
    if (!parseVector(value))
      return false;
  } else {
    const TokenKind kind = m_tokens.peek().kind;
    const bool sign = isSigned && (kind == TokenKind::Plus || kind == TokenKind::Minus);
    if (!sign && kind != TokenKind::Integer && kind != TokenKind::Float)
      return unexpected("a constant, state.* or program.*");
    if (!(isSigned ? parseScalar(value[0]) : parseNumber(value[0])))
      return false;
    value.fill(value[0]);
  }
  row = m_binder.constant(value, spanFrom(begin));
  return true;
}

} // namespace arbiter::fp
