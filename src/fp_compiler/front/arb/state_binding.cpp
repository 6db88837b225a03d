
#include "fp_compiler/front/arb/parser.h"

namespace arbiter::fp {

namespace {

using ir::MatrixModifier;
using ir::StateItem;

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
  if (acceptWord("matrix"))
    return parseMatrix(begin, range, rows);
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

/// Consumes one of the words, which is an item of state.
bool Parser::parseItem(const char *what, std::initializer_list<NamedItem> items,
                       ir::StateRef &ref) {
  std::vector<std::string_view> words;
  for (const NamedItem &item : items) {
    if (acceptWord(item.word)) {
      ref.item = item.item;
      return true;
    }
    words.push_back(item.word);
  }
  return unknownWord(what, words);
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
  return parseFace(ref) && parseItem("a material property",
                                     {{"ambient", StateItem::MaterialAmbient},
                                      {"diffuse", StateItem::MaterialDiffuse},
                                      {"specular", StateItem::MaterialSpecular},
                                      {"emission", StateItem::MaterialEmission},
                                      {"shininess", StateItem::MaterialShininess}},
                                     ref);
}

bool Parser::parseLight(ir::StateRef &ref) {
  std::uint32_t index = 0;
  if (!parseIndex(byteLimit(m_limits.lights), DiagnosticId::LightIndex, "light", index) ||
      !expect(TokenKind::Dot, "'.'"))
    return false;
  ref.index = std::uint8_t(index);
  if (!parseItem("a light property",
                 {{"ambient", StateItem::LightAmbient},
                  {"diffuse", StateItem::LightDiffuse},
                  {"specular", StateItem::LightSpecular},
                  {"position", StateItem::LightPosition},
                  {"attenuation", StateItem::LightAttenuation},
                  {"spot", StateItem::LightSpotDirection},
                  {"half", StateItem::LightHalf}},
                 ref))
    return false;
  return ref.item != StateItem::LightSpotDirection ||
         (expect(TokenKind::Dot, "'.direction'") &&
          parseItem("direction", {{"direction", StateItem::LightSpotDirection}}, ref));
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
  return parseItem("a light product",
                   {{"ambient", StateItem::LightProdAmbient},
                    {"diffuse", StateItem::LightProdDiffuse},
                    {"specular", StateItem::LightProdSpecular}},
                   ref);
}

bool Parser::parseTexEnv(ir::StateRef &ref) {
  std::uint32_t index = 0;
  if (!parseOptionalIndex(byteLimit(m_limits.textureUnits), DiagnosticId::TexEnvIndex,
                          "texture unit", index) ||
      !expect(TokenKind::Dot, "'.'"))
    return false;
  ref.index = std::uint8_t(index);
  return parseItem("color", {{"color", StateItem::TexEnvColor}}, ref);
}

bool Parser::parseFog(ir::StateRef &ref) {
  return expect(TokenKind::Dot, "'.'") &&
         parseItem("color or params",
                   {{"color", StateItem::FogColor}, {"params", StateItem::FogParams}}, ref);
}

bool Parser::parseDepth(ir::StateRef &ref) {
  return expect(TokenKind::Dot, "'.'") &&
         parseItem("range", {{"range", StateItem::DepthRange}}, ref);
}

bool Parser::parseMatrixName(ir::StateRef &ref) {
  if (!parseItem("a matrix",
                 {{"modelview", StateItem::MatrixModelview},
                  {"projection", StateItem::MatrixProjection},
                  {"mvp", StateItem::MatrixMvp},
                  {"texture", StateItem::MatrixTexture},
                  {"palette", StateItem::MatrixPalette},
                  {"program", StateItem::MatrixProgram}},
                 ref))
    return false;
  std::uint32_t index = 0;
  const auto id = DiagnosticId::MatrixIndex;
  bool parsed = true;
  if (ref.item == StateItem::MatrixModelview)
    parsed = parseOptionalIndex(byteLimit(m_limits.vertexUnits), id, "modelview matrix", index);
  else if (ref.item == StateItem::MatrixTexture)
    parsed = parseOptionalIndex(byteLimit(m_limits.textureCoords), id, "texture matrix", index);
  else if (ref.item == StateItem::MatrixPalette)
    parsed = parseIndex(byteLimit(m_limits.paletteMatrices), id, "palette matrix", index);
  else if (ref.item == StateItem::MatrixProgram)
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
    if (!acceptWord("row"))
      return ref.modifier == MatrixModifier::Plain
                 ? unknownWord("a matrix modifier or row",
                               {"inverse", "transpose", "invtrans", "row"})
                 : unknownWord("row", {"row"});
    if (!parseRange(4, DiagnosticId::MatrixRow, "matrix row", range, first, last) ||
        !expect(TokenKind::CloseBracket, "']'", range ? "" : "a range of rows belongs in an array"))
      return false;
  }
  for (std::uint32_t i = first; i <= last; ++i) {
    ref.row = std::uint8_t(i);
    rows.push_back(m_binder.state(ref, spanFrom(begin)));
  }
  return true;
}

} // namespace arbiter::fp
