// The state of fixed-function vertices that differs in code: lighting, texture coordinate
// generation, matrices that are the identity, clip planes.
#include <algorithm>
#include <cstring>

#include "state/mirror/mirror.h"
#include "state/mirror/mirror_groups.h"

namespace arbiter::state::software {

namespace {

constexpr int kLights = 8;

void askColorMaterial(const Ask &ask, VertexState &state) {
  state.colorMaterial = ask.enabled(GL_COLOR_MATERIAL);
  state.colorMaterialFace = state.colorMaterialParts = 0;
  if (!state.colorMaterial)
    return;
  const GLenum face = ask.name(GL_COLOR_MATERIAL_FACE);
  state.colorMaterialFace = std::uint8_t((face != GL_BACK ? 1 : 0) | (face != GL_FRONT ? 2 : 0));
  switch (ask.name(GL_COLOR_MATERIAL_PARAMETER)) {
  case GL_EMISSION:
    state.colorMaterialParts = 1;
    break;
  case GL_AMBIENT:
    state.colorMaterialParts = 2;
    break;
  case GL_DIFFUSE:
    state.colorMaterialParts = 4;
    break;
  case GL_SPECULAR:
    state.colorMaterialParts = 8;
    break;
  default:
    state.colorMaterialParts = 2 | 4; // AMBIENT_AND_DIFFUSE
    break;
  }
}

void askLight(const Ask &ask, int light, VertexState &state) {
  const GLenum name = GLenum(GL_LIGHT0 + light);
  const auto bit = std::uint8_t(1u << light);
  if (!ask.enabled(name))
    return;
  state.lights |= bit;
  const auto get = [&](GLenum pname) {
    GLfloat value = 0;
    ask.host.GetLightfv(name, pname, &value);
    return value;
  };
  GLfloat position[4] = {};
  ask.host.GetLightfv(name, GL_POSITION, position);
  if (get(GL_SPOT_CUTOFF) != 180.0f)
    state.spots |= bit;
  if (position[3] == 0)
    return;
  state.positional |= bit;
  if (get(GL_CONSTANT_ATTENUATION) != 1 || get(GL_LINEAR_ATTENUATION) != 0 ||
      get(GL_QUADRATIC_ATTENUATION) != 0)
    state.attenuated |= bit;
}

void askLighting(const Ask &ask, VertexState &state) {
  state.lighting = ask.enabled(GL_LIGHTING);
  askColorMaterial(ask, state);
  state.lights = state.positional = state.spots = state.attenuated = 0;
  if (!state.lighting)
    return;
  state.twoSided = ask.boolean(GL_LIGHT_MODEL_TWO_SIDE);
  state.localViewer = ask.boolean(GL_LIGHT_MODEL_LOCAL_VIEWER);
  state.separateSpecular = ask.name(GL_LIGHT_MODEL_COLOR_CONTROL) == GL_SEPARATE_SPECULAR_COLOR;
  for (int light = 0; light < kLights; ++light)
    askLight(ask, light, state);
}

std::uint8_t askTexGenMode(const Ask &ask, GLenum coordinate) {
  if (!ask.enabled(GL_TEXTURE_GEN_S + (coordinate - GL_S)))
    return 0;
  GLint mode = GL_EYE_LINEAR;
  ask.host.GetTexGeniv(coordinate, GL_TEXTURE_GEN_MODE, &mode);
  switch (mode) {
  case GL_OBJECT_LINEAR:
    return 1 + std::uint8_t(TexGenMode::ObjectLinear);
  case GL_SPHERE_MAP:
    return 1 + std::uint8_t(TexGenMode::Sphere);
  case GL_REFLECTION_MAP:
    return 1 + std::uint8_t(TexGenMode::Reflection);
  case GL_NORMAL_MAP:
    return 1 + std::uint8_t(TexGenMode::Normal);
  default:
    return 1 + std::uint8_t(TexGenMode::EyeLinear);
  }
}

void askTexGen(const HostCaps &caps, const Ask &ask, VertexState &state) {
  const UnitsScope units(ask.host);
  for (int unit = 0; unit < 8; ++unit) {
    state.texGen[std::size_t(unit)] = {};
    if (unit >= caps.maxTextureCoords)
      continue;
    units.select(unit);
    for (GLenum c = 0; c < 4; ++c)
      state.texGen[std::size_t(unit)][c] = askTexGenMode(ask, GL_S + c);
  }
}

bool isIdentity(const GLfloat matrix[16]) {
  for (int i = 0; i < 16; ++i)
    if (matrix[i] != (i % 5 == 0 ? 1.0f : 0.0f))
      return false;
  return true;
}

void askTransform(const HostCaps &caps, const Ask &ask, VertexState &state) {
  state.normalize = ask.enabled(GL_NORMALIZE);
  state.rescale = ask.enabled(GL_RESCALE_NORMAL);
  state.clipPlanes = 0;
  for (int plane = 0; plane < std::min(caps.maxClipPlanes, 8); ++plane)
    if (ask.enabled(GLenum(GL_CLIP_PLANE0 + plane)))
      state.clipPlanes |= std::uint8_t(1u << plane);
  state.textureMatrix = 0;
  const UnitsScope units(ask.host);
  for (int unit = 0; unit < std::min(caps.maxTextureCoords, 8); ++unit) {
    GLfloat matrix[16] = {};
    units.select(unit);
    ask.host.GetFloatv(GL_TEXTURE_MATRIX, matrix);
    if (!isIdentity(matrix))
      state.textureMatrix |= std::uint8_t(1u << unit);
  }
}

void askPointsAndFog(const Ask &ask, VertexState &state) {
  state.fogFromDepth = ask.name(GL_FOG_COORDINATE_SOURCE) == GL_FRAGMENT_DEPTH;
  GLfloat factors[3] = {1, 0, 0};
  ask.host.GetFloatv(GL_POINT_DISTANCE_ATTENUATION, factors);
  state.pointAttenuation = factors[0] != 1 || factors[1] != 0 || factors[2] != 0;
}

} // namespace

void Mirror::refreshVertexState(bool floatTarget) {
  constexpr std::uint32_t kGroups = dirty::kTransform | dirty::kLighting | dirty::kTexGen |
                                    dirty::kFog | dirty::kRaster | dirty::kPixelOps;
  const std::uint32_t groups = clock.changedSince(vertexSeen) & kGroups;
  vertexSeen = clock.now();
  const bool clamps = clampVertexColors && !(clampVertexFixedOnly && floatTarget);
  if (groups == 0 && clamps == vertex.clampColors) [[likely]]
    return;
  const VertexState before = vertex;
  VertexState &state = vertex;
  const Ask ask{m_host};
  if ((groups & dirty::kTransform) != 0)
    askTransform(m_caps, ask, state);
  if ((groups & dirty::kLighting) != 0)
    askLighting(ask, state);
  if ((groups & dirty::kTexGen) != 0)
    askTexGen(m_caps, ask, state);
  if ((groups & (dirty::kFog | dirty::kRaster)) != 0)
    askPointsAndFog(ask, state);
  state.clampColors = clamps;
  if (!(before == state))
    ++state.version;
}

} // namespace arbiter::state::software
