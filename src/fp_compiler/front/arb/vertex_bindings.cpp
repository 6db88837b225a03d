// Parses bindings that only vertex programs have (ARB_vertex_program 2.14.3).

#include "fp_compiler/front/arb/parser.h"

namespace arbiter::fp {

/// Parses a <vtxAttribItem> that fragment programs lack.
bool Parser::parseVertexAttribute(ir::Attribute &attribute) {
  if (acceptWord("normal")) {
    attribute.kind = ir::AttributeKind::Normal;
    return true;
  }
  if (acceptWord("attrib")) {
    std::uint32_t index = 0;
    attribute.kind = ir::AttributeKind::Generic;
    if (atAddress()) {
      attribute.index = 0; // stands for them all, and is one of them
      return parseIndexedAttribute(m_attribs, attribute.kind, m_limits.vertexAttribs);
    }
    if (!parseIndex(byteLimit(m_limits.vertexAttribs), DiagnosticId::AttributeIndex,
                    "vertex attribute", index))
      return false;
    attribute.index = std::uint8_t(index);
    return true;
  }
  const bool weight = atWord("weight");
  if (!weight && !atWord("matrixindex"))
    return unknownWord("a vertex attribute",
                       {"position", "normal", "color", "fogcoord", "texcoord", "attrib"});
  const Token word = m_tokens.next();
  if (weight && m_limits.nvOptions != 0)
    return parseVertexWeight(word, attribute);
  error(DiagnosticId::AttributeExtension, word.span,
        "vertex." + std::string(text(word)) + " needs " +
            (weight ? "ARB_vertex_blend" : "ARB_matrix_palette") + ", which is not offered",
        "pass it as a generic attribute, vertex.attrib[n]");
  return false;
}

/// Parses vertex.weight if NVIDIA's programs are offered. NVIDIA's drivers have neither
/// EXT_vertex_weighting nor ARB_vertex_blend. They read generic attribute 1, which the weights
/// alias (ARB_vertex_program, table X.2). A program with both names has one attribute.
bool Parser::parseVertexWeight(const Token &word, ir::Attribute &attribute) {
  std::uint32_t index = 0;
  if (!parseOptionalIndex(1, DiagnosticId::AttributeIndex, "vertex weight", index))
    return false;
  attribute = {ir::AttributeKind::Generic, 1};
  warning(DiagnosticId::AttributeExtension, word.span,
          "vertex.weight without ARB_vertex_blend is generic attribute 1",
          "weights are given by VertexAttrib4fARB(1, ...) or its array");
  return true;
}

/// Parses <resultBinding>, after its dot.
bool Parser::parseVertexResult(ir::Output &output) {
  if (atWord("color"))
    return parseVertexColor(output);
  if (atWord("position")) {
    const Token word = m_tokens.next();
    output.kind = ir::OutputKind::Position;
    if (m_options.positionInvariant)
      error(DiagnosticId::InvariantPosition, word.span,
            "result.position under OPTION ARB_position_invariant",
            "the option computes the position; remove one of the two");
    return true;
  }
  if (acceptWord("texcoord")) {
    output.kind = ir::OutputKind::TexCoord;
    if (!atAddress())
      return parseTexCoord(output.index);
    return parseIndexed(m_texCoordResults, m_limits.textureCoords, [&](std::uint8_t index) {
      return m_binder.output({output.kind, index});
    });
  }
  if (atWord("fogcoord") || atWord("pointsize")) {
    output.kind =
        text(m_tokens.next()) == "fogcoord" ? ir::OutputKind::FogCoord : ir::OutputKind::PointSize;
    return true;
  }
  if (atWord("clip"))
    return parseClipDistance(output);
  return unknownWord("a vertex result", {"position", "color", "fogcoord", "pointsize", "texcoord"},
                     {"depth"});
}

/// Parses "clip" "[" <clipPlaneNum> "]" of NV_vertex_program2_option.
bool Parser::parseClipDistance(ir::Output &output) {
  const Token word = m_tokens.next();
  if (!isNv()) {
    error(DiagnosticId::NvOnly, word.span, "result.clip" + ofNvOptions(),
          "OPTION ARB_position_invariant clips as fixed function does");
    return false;
  }
  std::uint32_t index = 0;
  output.kind = ir::OutputKind::ClipDistance;
  if (!parseIndex(byteLimit(m_limits.clipPlanes), DiagnosticId::ClipPlaneIndex, "clip plane",
                  index))
    return false;
  output.index = std::uint8_t(index);
  return true;
}

/// Parses <resultColBinding>. A suffix that is not a face or a colour type is a mask.
bool Parser::parseVertexColor(ir::Output &output) {
  m_tokens.next();
  if (at(TokenKind::OpenBracket)) {
    foreign(m_tokens.peek(), "result.color[n]");
    return false;
  }
  const auto accept = [&](std::string_view word) {
    if (!at(TokenKind::Dot) || !atWord(word, 1))
      return false;
    m_tokens.next();
    m_tokens.next();
    return true;
  };
  const bool back = !accept("front") && accept("back");
  const bool secondary = !accept("primary") && accept("secondary");
  output.kind = back ? (secondary ? ir::OutputKind::BackSecondary : ir::OutputKind::BackPrimary)
                     : (secondary ? ir::OutputKind::FrontSecondary : ir::OutputKind::FrontPrimary);
  return true;
}

/// Parses <stateTexGenItem>, after "texgen".
bool Parser::parseTexGen(ir::StateRef &ref) {
  std::uint32_t index = 0;
  if (!parseOptionalIndex(byteLimit(m_limits.textureCoords), DiagnosticId::TexCoordIndex,
                          "texture coordinate set", index) ||
      !expect(TokenKind::Dot, "'.'"))
    return false;
  ref.index = std::uint8_t(index);
  if (!parseItem("eye or object",
                 {{"eye", ir::StateItem::TexGenEye}, {"object", ir::StateItem::TexGenObject}},
                 ref) ||
      !expect(TokenKind::Dot, "'.'"))
    return false;
  for (const std::string_view word : {"s", "t", "r", "q"}) {
    if (acceptWord(word))
      return true;
    ++ref.row;
  }
  return unknownWord("a texture coordinate", {"s", "t", "r", "q"});
}

/// Parses <stateClipPlaneItem>, after "clip".
bool Parser::parseClipPlane(ir::StateRef &ref) {
  std::uint32_t index = 0;
  if (!parseIndex(byteLimit(m_limits.clipPlanes), DiagnosticId::ClipPlaneIndex, "clip plane",
                  index) ||
      !expect(TokenKind::Dot, "'.plane'"))
    return false;
  ref.index = std::uint8_t(index);
  return parseItem("plane", {{"plane", ir::StateItem::ClipPlane}}, ref);
}

/// Parses <statePointItem>, after "point".
bool Parser::parsePoint(ir::StateRef &ref) {
  return expect(TokenKind::Dot, "'.'") &&
         parseItem(
             "size or attenuation",
             {{"size", ir::StateItem::PointSize}, {"attenuation", ir::StateItem::PointAttenuation}},
             ref);
}

} // namespace arbiter::fp
