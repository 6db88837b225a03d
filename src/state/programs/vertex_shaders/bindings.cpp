#include "state/programs/vertex_shaders/bindings.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/core/host_state.h"
#include "state/core/unit_scope.h"
#include "state/programs/program_context.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

using fp::ir::AttributeKind;
using fp::ir::StateItem;
using fp::ir::StateRef;
using fp::vertex_shader::DataType;
using fp::vertex_shader::From;

VertexSymbol ofState(DataType type, const StateRef &state, int component = 0) {
  VertexSymbol symbol;
  symbol.bound = true;
  symbol.storage = GL_INVARIANT_EXT;
  symbol.meaning.type = type;
  symbol.meaning.from = From::State;
  symbol.meaning.state = state;
  symbol.meaning.component = std::uint8_t(component);
  return symbol;
}

VertexSymbol ofAttribute(AttributeKind kind, GLuint index = 0) {
  VertexSymbol symbol;
  symbol.bound = true;
  symbol.storage = GL_VARIANT_EXT;
  symbol.meaning.from = From::Attribute;
  symbol.meaning.attributes[0] = {kind, std::uint8_t(index)};
  symbol.meaning.isDirection = kind == AttributeKind::Normal;
  return symbol;
}

/// Returns a symbol whose value draws must query.
VertexSymbol follower(DataType type, VertexSymbol::Follows follows, GLuint light = 0) {
  VertexSymbol symbol = ofState(type, {});
  symbol.meaning.from = From::Invariant;
  symbol.follows = follows;
  symbol.light = light;
  return symbol;
}

std::optional<VertexSymbol> lightParameter(std::uint8_t light, GLenum value) {
  const auto of = [&](StateItem item, DataType type, int component = 0) {
    return ofState(type, {.item = item, .index = light}, component);
  };
  switch (value) {
  case GL_AMBIENT:
    return of(StateItem::LightAmbient, DataType::Vector);
  case GL_DIFFUSE:
    return of(StateItem::LightDiffuse, DataType::Vector);
  case GL_SPECULAR:
    return of(StateItem::LightSpecular, DataType::Vector);
  case GL_POSITION:
    return of(StateItem::LightPosition, DataType::Vector);
  case GL_CONSTANT_ATTENUATION:
    return of(StateItem::LightAttenuation, DataType::Scalar, 0);
  case GL_LINEAR_ATTENUATION:
    return of(StateItem::LightAttenuation, DataType::Scalar, 1);
  case GL_QUADRATIC_ATTENUATION:
    return of(StateItem::LightAttenuation, DataType::Scalar, 2);
  case GL_SPOT_EXPONENT:
    return of(StateItem::LightAttenuation, DataType::Scalar, 3);
  case GL_SPOT_DIRECTION: {
    VertexSymbol symbol = of(StateItem::LightSpotDirection, DataType::Vector);
    symbol.meaning.isDirection = true;
    return symbol;
  }
  case GL_SPOT_CUTOFF: // program languages only have its cosine
    return follower(DataType::Scalar, VertexSymbol::Follows::SpotCutoff, light);
  default:
    return std::nullopt;
  }
}

std::optional<VertexSymbol> materialParameter(bool back, GLenum value) {
  const auto of = [&](StateItem item, DataType type) {
    VertexSymbol symbol = ofState(type, {.item = item, .back = back});
    symbol.storage = GL_VARIANT_EXT;
    return symbol;
  };
  switch (value) {
  case GL_AMBIENT:
    return of(StateItem::MaterialAmbient, DataType::Vector);
  case GL_DIFFUSE:
    return of(StateItem::MaterialDiffuse, DataType::Vector);
  case GL_SPECULAR:
    return of(StateItem::MaterialSpecular, DataType::Vector);
  case GL_EMISSION:
    return of(StateItem::MaterialEmission, DataType::Vector);
  case GL_SHININESS:
    return of(StateItem::MaterialShininess, DataType::Scalar);
  default:
    return std::nullopt;
  }
}

std::optional<VertexSymbol> parameter(const ProgramContext &context, GLenum value) {
  const auto matrix = [](StateItem item) { return ofState(DataType::Matrix, {.item = item}); };
  const auto fog = [](int component) {
    return ofState(DataType::Scalar, {.item = StateItem::FogParams}, component);
  };
  switch (value) {
  case GL_CURRENT_VERTEX_EXT:
    return ofAttribute(AttributeKind::Position);
  case GL_CURRENT_NORMAL:
    return ofAttribute(AttributeKind::Normal);
  case GL_CURRENT_COLOR:
    return ofAttribute(AttributeKind::ColorPrimary);
  case GL_MODELVIEW_MATRIX:
    return matrix(StateItem::MatrixModelview);
  case GL_PROJECTION_MATRIX:
    return matrix(StateItem::MatrixProjection);
  case GL_MVP_MATRIX_EXT:
    return matrix(StateItem::MatrixMvp);
  case GL_COLOR_MATRIX:
    if (!hasColorMatrix(context))
      return std::nullopt;
    return follower(DataType::Matrix, VertexSymbol::Follows::ColorMatrix);
  case GL_FOG_COLOR:
    return ofState(DataType::Vector, {.item = StateItem::FogColor});
  case GL_FOG_DENSITY:
    return fog(0);
  case GL_FOG_START:
    return fog(1);
  case GL_FOG_END:
    return fog(2);
  case GL_LIGHT_MODEL_AMBIENT:
    return ofState(DataType::Vector, {.item = StateItem::LightModelAmbient});
  default:
    break;
  }
  const GLuint plane = value - GL_CLIP_PLANE0;
  if (plane >= context.row(Target::VertexShader).limits.clipPlanes)
    return std::nullopt;
  return ofState(DataType::Vector, {.item = StateItem::ClipPlane, .index = std::uint8_t(plane)});
}

/// Returns the share group's name of the symbol. A key begins with the enumerant that was bound.
GLuint nameOf(ProgramContext &context, const std::optional<VertexSymbol> &symbol, const char *why,
              const std::array<GLenum, 3> &key) {
  if (!symbol) {
    raise(context, GL_INVALID_ENUM, why);
    return 0;
  }
  const GLuint name = context.group->vertexSymbols.bind(*symbol, key);
  if (name == 0)
    raise(context, GL_OUT_OF_MEMORY, why);
  return name;
}

} // namespace

GLuint bindLightParameter(ProgramContext &context, GLenum light, GLenum value) {
  const GLuint number = light - GL_LIGHT0;
  const bool isLight = number < context.row(Target::VertexShader).limits.lights;
  return nameOf(context, isLight ? lightParameter(std::uint8_t(number), value) : std::nullopt,
                "BindLightParameter: light or value", {light, value, 0});
}

GLuint bindMaterialParameter(ProgramContext &context, GLenum face, GLenum value) {
  const bool isFace = face == GL_FRONT || face == GL_BACK;
  return nameOf(context, isFace ? materialParameter(face == GL_BACK, value) : std::nullopt,
                "BindMaterialParameter: face or value", {face, value, 0});
}

GLuint bindTexGenParameter(ProgramContext &context, GLenum unit, GLenum coord, GLenum value) {
  const GLuint number = unit - GL_TEXTURE0, row = coord - GL_S;
  std::optional<VertexSymbol> symbol;
  if (number < context.row(Target::VertexShader).limits.textureUnits && row < 4 &&
      (value == GL_EYE_PLANE || value == GL_OBJECT_PLANE))
    symbol = ofState(DataType::Vector, {.item = value == GL_EYE_PLANE ? StateItem::TexGenEye
                                                                      : StateItem::TexGenObject,
                                        .index = std::uint8_t(number),
                                        .row = std::uint8_t(row)});
  return nameOf(context, symbol, "BindTexGenParameter: unit, coord or value", {unit, coord, value});
}

GLuint bindTextureUnitParameter(ProgramContext &context, GLenum unit, GLenum value) {
  const GLuint number = unit - GL_TEXTURE0;
  std::optional<VertexSymbol> symbol;
  if (number < context.row(Target::VertexShader).limits.textureUnits) {
    if (value == GL_CURRENT_TEXTURE_COORDS)
      symbol = ofAttribute(AttributeKind::TexCoord, number);
    else if (value == GL_TEXTURE_MATRIX)
      symbol = ofState(DataType::Matrix,
                       {.item = StateItem::MatrixTexture, .index = std::uint8_t(number)});
  }
  return nameOf(context, symbol, "BindTextureUnitParameter: unit or value", {unit, value, 1});
}

GLuint bindParameter(ProgramContext &context, GLenum value) {
  return nameOf(context, parameter(context, value), "BindParameter: value", {value, 0, 0});
}

Vec4 boundValue(ProgramContext &context, const VertexSymbol &symbol, std::size_t row) {
  const fp::vertex_shader::Symbol &meaning = symbol.meaning;
  Vec4 value = {0.0f, 0.0f, 0.0f, 1.0f};
  if (symbol.follows != VertexSymbol::Follows::Nothing)
    return followedValue(context, symbol, row);
  if (meaning.from == From::State) {
    StateRef state = meaning.state;
    state.row = std::uint8_t(state.row + row);
    fetchState(context, state, value.data());
    if (meaning.type == DataType::Scalar)
      value[0] = value[meaning.component];
  } else if (meaning.attributes[0].kind == AttributeKind::Normal) {
    context.host->GetFloatv(GL_CURRENT_NORMAL, value.data());
  } else if (meaning.attributes[0].kind == AttributeKind::ColorPrimary) {
    context.host->GetFloatv(GL_CURRENT_COLOR, value.data());
  } else if (meaning.attributes[0].kind == AttributeKind::TexCoord) {
    const UnitScope unit(*context.host, meaning.attributes[0].index);
    context.host->GetFloatv(GL_CURRENT_TEXTURE_COORDS, value.data());
  }
  if (meaning.isDirection)
    value[3] = 0.0f;
  return value;
}

} // namespace arbiter::state
