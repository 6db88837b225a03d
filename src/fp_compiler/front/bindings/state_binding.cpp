
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

} // namespace

/// Parses <stateSingleItem> or <stateMultipleItem>, after "state" (tables X.2.2 to X.2.7).
bool Parser::parseStateBinding(std::uint32_t begin, bool range, Rows &rows) {
  if (!expect(TokenKind::Dot, "'.'"))
    return false;
  if (atWord("matrix")) {
    m_tokens.next();
    return parseMatrix(begin, range, rows);
  }
  struct Group {
    std::string_view word;
    bool (Parser::*parse)(ir::StateRef &);
    std::optional<ir::Language> only;
  };
  static constexpr Group kGroups[] = {
      {"material", &Parser::parseMaterial, std::nullopt},
      {"light", &Parser::parseLight, std::nullopt},
      {"lightmodel", &Parser::parseLightModel, std::nullopt},
      {"lightprod", &Parser::parseLightProduct, std::nullopt},
      {"fog", &Parser::parseFog, std::nullopt},
      {"texenv", &Parser::parseTexEnv, ir::Language::ArbFragment},
      {"depth", &Parser::parseDepth, ir::Language::ArbFragment},
      {"texgen", &Parser::parseTexGen, ir::Language::ArbVertex},
      {"clip", &Parser::parseClipPlane, ir::Language::ArbVertex},
      {"point", &Parser::parsePoint, ir::Language::ArbVertex},
  };
  const Token word = m_tokens.peek();
  for (const Group &group : kGroups) {
    if (!atWord(group.word))
      continue;
    if (group.only && *group.only != m_language.language) {
      foreign(word, quote(group.word));
      return false;
    }
    m_tokens.next();
    ir::StateRef ref;
    if (!(this->*group.parse)(ref))
      return false;
    rows.push_back(m_binder.state(ref, spanFrom(begin)));
    return true;
  }
  return isVertex() ? unknownWord("a state group", {"material", "light", "lightmodel", "lightprod",
                                                    "texgen", "fog", "clip", "point", "matrix"})
                    : unknownWord("a state group", {"material", "light", "lightmodel", "lightprod",
                                                    "texenv", "fog", "depth", "matrix"});
}

/// Parses <optFaceType> and the dot before the next property.
bool Parser::parseFace(ir::StateRef &ref) {
  if (!expect(TokenKind::Dot, "'.'"))
    return false;
  if (!atWord("front") && !atWord("back"))
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
  if (!atWord("direction"))
    return unknownWord("direction", {"direction"});
  m_tokens.next();
  return true;
}

bool Parser::parseLightModel(ir::StateRef &ref) {
  if (!expect(TokenKind::Dot, "'.'"))
    return false;
  const bool face = atWord("front") || atWord("back");
  if (face) {
    ref.back = text(m_tokens.next()) == "back";
    if (!expect(TokenKind::Dot, "'.scenecolor'"))
      return false;
  }
  if (atWord("scenecolor"))
    ref.item = StateItem::LightModelSceneColor;
  else if (atWord("ambient") && !face)
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
  if (!atWord("color"))
    return unknownWord("color", {"color"});
  m_tokens.next();
  return true;
}

bool Parser::parseFog(ir::StateRef &ref) {
  if (!expect(TokenKind::Dot, "'.'"))
    return false;
  if (!atWord("color") && !atWord("params"))
    return unknownWord("color or params", {"color", "params"});
  ref.item = text(m_tokens.next()) == "color" ? StateItem::FogColor : StateItem::FogParams;
  return true;
}

bool Parser::parseDepth(ir::StateRef &ref) {
  if (!expect(TokenKind::Dot, "'.'"))
    return false;
  if (!atWord("range"))
    return unknownWord("range", {"range"});
  m_tokens.next();
  ref.item = StateItem::DepthRange;
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

/// Parses <stateMatrixRow> or <stateMatrixRows>, after "matrix".
bool Parser::parseMatrix(std::uint32_t begin, bool range, Rows &rows) {
  ir::StateRef ref;
  if (!expect(TokenKind::Dot, "'.'") || !parseMatrixName(ref))
    return false;
  if (at(TokenKind::Dot) && m_tokens.peek(1).kind == TokenKind::Identifier) {
    if (const auto modifier = findModifier(text(m_tokens.peek(1)))) {
      m_tokens.next();
      m_tokens.next();
      ref.modifier = *modifier;
    }
  }
  std::uint32_t first = 0;
  std::uint32_t last = 3;
  if (!range || at(TokenKind::Dot)) {
    if (!expect(TokenKind::Dot, "'.row[n]'",
                "a whole matrix belongs in an array: PARAM m[4] = { state.matrix.mvp }"))
      return false;
    if (!atWord("row"))
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

/// Parses "[" a "]" or, in an array, "[" a ".." b "]".
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
