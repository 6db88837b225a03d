#include <algorithm>

#include "fp_compiler/front/parser.h"

namespace arbiter::fp {

namespace {

using ir::MatrixModifier;
using ir::StateItem;

struct NamedItem {
  std::string_view word;
  StateItem item;
};

std::optional<StateItem> find(std::initializer_list<NamedItem> items, std::string_view word) {
  for (const NamedItem &item : items)
    if (item.word == word)
      return item.item;
  return std::nullopt;
}

std::optional<MatrixModifier> findModifier(std::string_view word) {
  if (word == "inverse")
    return MatrixModifier::Inverse;
  if (word == "transpose")
    return MatrixModifier::Transpose;
  if (word == "invtrans")
    return MatrixModifier::InvTrans;
  return std::nullopt;
}

/// An index is kept in eight bits; no GL has so much of anything that this binds.
std::uint32_t byteLimit(std::uint32_t limit) { return std::min(limit, 256u); }

} // namespace

/// <stateSingleItem> or <stateMultipleItem>, after "state" (tables X.2.2 to X.2.7).
bool Parser::parseStateBinding(std::uint32_t begin, bool range, Rows &rows) {
  if (!expect(TokenKind::Dot, "'.'"))
    return false;
  const std::string_view group =
      m_tokens.at(TokenKind::Identifier) ? text(m_tokens.peek()) : std::string_view();
  ir::StateRef ref;
  bool parsed = false;
  if (group == "matrix") {
    m_tokens.next();
    return parseMatrix(begin, range, rows);
  }
  if (group == "material") {
    m_tokens.next();
    parsed = parseMaterial(ref);
  } else if (group == "light") {
    m_tokens.next();
    parsed = parseLight(ref);
  } else if (group == "lightmodel") {
    m_tokens.next();
    parsed = parseLightModel(ref);
  } else if (group == "lightprod") {
    m_tokens.next();
    parsed = parseLightProduct(ref);
  } else if (group == "texenv") {
    m_tokens.next();
    parsed = parseTexEnv(ref);
  } else if (group == "fog" || group == "depth") {
    m_tokens.next();
    parsed = parseFogOrDepth(ref, group == "fog");
  } else {
    return unknownWord(
        "a state group",
        {"material", "light", "lightmodel", "lightprod", "texenv", "fog", "depth", "matrix"},
        {"texgen", "clip", "point"});
  }
  if (parsed)
    rows.push_back(m_binder.state(ref, spanFrom(begin)));
  return parsed;
}

/// <optFaceType> and the dot of the property behind it.
bool Parser::parseFace(ir::StateRef &ref) {
  if (!expect(TokenKind::Dot, "'.'"))
    return false;
  if (!atWord(0, "front") && !atWord(0, "back"))
    return true;
  ref.back = text(m_tokens.next()) == "back";
  return expect(TokenKind::Dot, "'.'");
}

bool Parser::parseMaterial(ir::StateRef &ref) {
  if (!parseFace(ref))
    return false;
  const auto item = find({{"ambient", StateItem::MaterialAmbient},
                          {"diffuse", StateItem::MaterialDiffuse},
                          {"specular", StateItem::MaterialSpecular},
                          {"emission", StateItem::MaterialEmission},
                          {"shininess", StateItem::MaterialShininess}},
                         text(m_tokens.peek()));
  if (!item)
    return unknownWord("a material property",
                       {"ambient", "diffuse", "specular", "emission", "shininess"});
  m_tokens.next();
  ref.item = *item;
  return true;
}

bool Parser::parseLight(ir::StateRef &ref) {
  std::uint32_t index = 0;
  if (!parseIndex(byteLimit(m_limits.lights), DiagnosticId::LightIndex, "light", index) ||
      !expect(TokenKind::Dot, "'.'"))
    return false;
  ref.index = std::uint8_t(index);
  const auto item = find({{"ambient", StateItem::LightAmbient},
                          {"diffuse", StateItem::LightDiffuse},
                          {"specular", StateItem::LightSpecular},
                          {"position", StateItem::LightPosition},
                          {"attenuation", StateItem::LightAttenuation},
                          {"spot", StateItem::LightSpotDirection},
                          {"half", StateItem::LightHalf}},
                         text(m_tokens.peek()));
  if (!item)
    return unknownWord("a light property", {"ambient", "diffuse", "specular", "position",
                                            "attenuation", "spot", "half"});
  m_tokens.next();
  ref.item = *item;
  if (*item != StateItem::LightSpotDirection)
    return true;
  if (!expect(TokenKind::Dot, "'.direction'"))
    return false;
  if (!atWord(0, "direction"))
    return unknownWord("direction", {"direction"});
  m_tokens.next();
  return true;
}

bool Parser::parseLightModel(ir::StateRef &ref) {
  if (!expect(TokenKind::Dot, "'.'"))
    return false;
  const bool face = atWord(0, "front") || atWord(0, "back");
  if (face) {
    ref.back = text(m_tokens.next()) == "back";
    if (!expect(TokenKind::Dot, "'.scenecolor'"))
      return false;
  }
  if (atWord(0, "scenecolor"))
    ref.item = StateItem::LightModelSceneColor;
  else if (atWord(0, "ambient") && !face)
    ref.item = StateItem::LightModelAmbient;
  else if (face)
    return unknownWord("scenecolor", {"scenecolor"});
  else
    return unknownWord("a light model property", {"ambient", "scenecolor", "front", "back"});
  m_tokens.next();
  return true;
}

bool Parser::parseLightProduct(ir::StateRef &ref) {
  std::uint32_t index = 0;
  if (!parseIndex(byteLimit(m_limits.lights), DiagnosticId::LightIndex, "light", index) ||
      !parseFace(ref))
    return false;
  ref.index = std::uint8_t(index);
  const auto item = find({{"ambient", StateItem::LightProdAmbient},
                          {"diffuse", StateItem::LightProdDiffuse},
                          {"specular", StateItem::LightProdSpecular}},
                         text(m_tokens.peek()));
  if (!item)
    return unknownWord("a light product", {"ambient", "diffuse", "specular"});
  m_tokens.next();
  ref.item = *item;
  return true;
}

bool Parser::parseTexEnv(ir::StateRef &ref) {
  std::uint32_t index = 0;
  if (!parseOptionalIndex(byteLimit(m_limits.textureUnits), DiagnosticId::TexEnvIndex,
                          "texture unit", index) ||
      !expect(TokenKind::Dot, "'.'"))
    return false;
  ref.index = std::uint8_t(index);
  ref.item = StateItem::TexEnvColor;
  if (!atWord(0, "color"))
    return unknownWord("color", {"color"});
  m_tokens.next();
  return true;
}

bool Parser::parseFogOrDepth(ir::StateRef &ref, bool fog) {
  if (!expect(TokenKind::Dot, "'.'"))
    return false;
  if (fog && atWord(0, "color"))
    ref.item = StateItem::FogColor;
  else if (fog && atWord(0, "params"))
    ref.item = StateItem::FogParams;
  else if (!fog && atWord(0, "range"))
    ref.item = StateItem::DepthRange;
  else if (fog)
    return unknownWord("color or params", {"color", "params"});
  else
    return unknownWord("range", {"range"});
  m_tokens.next();
  return true;
}

bool Parser::parseMatrixName(ir::StateRef &ref) {
  const auto item = find({{"modelview", StateItem::MatrixModelview},
                          {"projection", StateItem::MatrixProjection},
                          {"mvp", StateItem::MatrixMvp},
                          {"texture", StateItem::MatrixTexture},
                          {"palette", StateItem::MatrixPalette},
                          {"program", StateItem::MatrixProgram}},
                         text(m_tokens.peek()));
  if (!item)
    return unknownWord("a matrix",
                       {"modelview", "projection", "mvp", "texture", "palette", "program"});
  m_tokens.next();
  ref.item = *item;
  std::uint32_t index = 0;
  const auto id = DiagnosticId::MatrixIndex;
  bool parsed = true;
  if (*item == StateItem::MatrixModelview)
    parsed = parseOptionalIndex(byteLimit(m_limits.vertexUnits), id, "modelview matrix", index);
  else if (*item == StateItem::MatrixTexture)
    parsed = parseOptionalIndex(byteLimit(m_limits.textureCoords), id, "texture matrix", index);
  else if (*item == StateItem::MatrixPalette)
    parsed = parseIndex(byteLimit(m_limits.paletteMatrices), id, "palette matrix", index);
  else if (*item == StateItem::MatrixProgram)
    parsed = parseIndex(byteLimit(m_limits.programMatrices), id, "program matrix", index);
  ref.index = std::uint8_t(index);
  return parsed;
}

/// <stateMatrixRow> or <stateMatrixRows>, after "matrix".
bool Parser::parseMatrix(std::uint32_t begin, bool range, Rows &rows) {
  ir::StateRef ref;
  if (!expect(TokenKind::Dot, "'.'") || !parseMatrixName(ref))
    return false;
  if (m_tokens.at(TokenKind::Dot) && m_tokens.peek(1).kind == TokenKind::Identifier) {
    if (const auto modifier = findModifier(text(m_tokens.peek(1)))) {
      m_tokens.next();
      m_tokens.next();
      ref.modifier = *modifier;
    }
  }
  std::uint32_t first = 0;
  std::uint32_t last = 3;
  if (!range || m_tokens.at(TokenKind::Dot)) {
    if (!expect(TokenKind::Dot, "'.row[n]'",
                "a whole matrix belongs in an array: PARAM m[4] = { state.matrix.mvp }"))
      return false;
    if (!atWord(0, "row"))
      return ref.modifier == MatrixModifier::Plain
                 ? unknownWord("a matrix modifier or row",
                               {"inverse", "transpose", "invtrans", "row"})
                 : unknownWord("row", {"row"});
    m_tokens.next();
    if (!parseMatrixRows(range, first, last))
      return false;
  }
  for (std::uint32_t i = first; i <= last; ++i) {
    ref.row = std::uint8_t(i);
    rows.push_back(m_binder.state(ref, spanFrom(begin)));
  }
  return true;
}

/// "[" a "]" or, in an array, "[" a ".." b "]".
bool Parser::parseMatrixRows(bool range, std::uint32_t &first, std::uint32_t &last) {
  const std::size_t errorsBefore = m_reporter.errorCount();
  if (!expect(TokenKind::OpenBracket, "'['") ||
      !parseBounded(4, DiagnosticId::MatrixRow, "matrix row", first))
    return false;
  last = first;
  if (range && m_tokens.accept(TokenKind::DotDot)) {
    const Token token = m_tokens.peek();
    if (!parseBounded(4, DiagnosticId::MatrixRow, "matrix row", last))
      return false;
    if (last < first && m_reporter.errorCount() == errorsBefore)
      error(DiagnosticId::ReversedRange, token.span, "the range runs backwards");
  }
  if (m_reporter.errorCount() != errorsBefore)
    last = first;
  return expect(TokenKind::CloseBracket, "']'", range ? "" : "a range of rows belongs in an array");
}

} // namespace arbiter::fp
