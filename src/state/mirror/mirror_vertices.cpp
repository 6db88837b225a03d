// Queries fixed-function vertex state that selects code: lighting, texture coordinate generation,
// identity matrices, clip planes.
#include <algorithm>
#include <cstring>

#include "state/mirror/mirror.h"
#include "state/mirror/mirror_groups.h"

namespace arbiter::state {

namespace {

constexpr int kLights = 8;

void queryColorMaterial(const HostQuery &query, VertexState &state) {
  state.colorMaterial = query.enabled(GL_COLOR_MATERIAL);
  state.colorMaterialFace = state.colorMaterialParts = 0;
  if (!state.colorMaterial)
    return;
  const GLenum face = query.name(GL_COLOR_MATERIAL_FACE);
  state.colorMaterialFace = std::uint8_t((face != GL_BACK ? 1 : 0) | (face != GL_FRONT ? 2 : 0));
  switch (query.name(GL_COLOR_MATERIAL_PARAMETER)) {
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

void queryLight(const HostQuery &query, int light, VertexState &state) {
  const GLenum name = GLenum(GL_LIGHT0 + light);
  const auto bit = std::uint8_t(1u << light);
  if (!query.enabled(name))
    return;
  state.lights |= bit;
  const auto get = [&](GLenum pname) {
    GLfloat value = 0;
    query.host.GetLightfv(name, pname, &value);
    return value;
  };
  GLfloat position[4] = {};
  query.host.GetLightfv(name, GL_POSITION, position);
  if (get(GL_SPOT_CUTOFF) != 180.0f)
    state.spots |= bit;
  if (position[3] == 0)
    return;
  state.positional |= bit;
  if (get(GL_CONSTANT_ATTENUATION) != 1 || get(GL_LINEAR_ATTENUATION) != 0 ||
      get(GL_QUADRATIC_ATTENUATION) != 0)
    state.attenuated |= bit;
}

void queryLighting(const HostQuery &query, VertexState &state) {
  state.lighting = query.enabled(GL_LIGHTING);
  queryColorMaterial(query, state);
  state.lights = state.positional = state.spots = state.attenuated = 0;
  if (!state.lighting)
    return;
  state.twoSided = query.boolean(GL_LIGHT_MODEL_TWO_SIDE);
  state.localViewer = query.boolean(GL_LIGHT_MODEL_LOCAL_VIEWER);
  state.separateSpecular = query.name(GL_LIGHT_MODEL_COLOR_CONTROL) == GL_SEPARATE_SPECULAR_COLOR;
  for (int light = 0; light < kLights; ++light)
    queryLight(query, light, state);
}

std::uint8_t queryTexGenMode(const HostQuery &query, GLenum coordinate) {
  if (!query.enabled(GL_TEXTURE_GEN_S + (coordinate - GL_S)))
    return 0;
  GLint mode = GL_EYE_LINEAR;
  query.host.GetTexGeniv(coordinate, GL_TEXTURE_GEN_MODE, &mode);
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

void queryTexGen(const HostCaps &caps, const HostQuery &query, VertexState &state) {
  const UnitsScope units(query.host);
  for (int unit = 0; unit < 8; ++unit) {
    state.texGen[std::size_t(unit)] = {};
    if (unit >= caps.maxTextureCoords)
      continue;
    units.select(unit);
    for (GLenum c = 0; c < 4; ++c)
      state.texGen[std::size_t(unit)][c] = queryTexGenMode(query, GL_S + c);
  }
}

bool isIdentity(const GLfloat matrix[16]) {
  for (int i = 0; i < 16; ++i)
    if (matrix[i] != (i % 5 == 0 ? 1.0f : 0.0f))
      return false;
  return true;
}

void queryTransform(const HostCaps &caps, const HostQuery &query, VertexState &state) {
  state.normalize = query.enabled(GL_NORMALIZE);
  state.rescale = query.enabled(GL_RESCALE_NORMAL);
  state.clipPlanes = 0;
  for (int plane = 0; plane < std::min(caps.maxClipPlanes, 8); ++plane)
    if (query.enabled(GLenum(GL_CLIP_PLANE0 + plane)))
      state.clipPlanes |= std::uint8_t(1u << plane);
  state.textureMatrix = 0;
  const UnitsScope units(query.host);
  for (int unit = 0; unit < std::min(caps.maxTextureCoords, 8); ++unit) {
    GLfloat matrix[16] = {};
    units.select(unit);
    query.host.GetFloatv(GL_TEXTURE_MATRIX, matrix);
    if (!isIdentity(matrix))
      state.textureMatrix |= std::uint8_t(1u << unit);
  }
}

void queryPointsAndFog(const HostQuery &query, const HostCaps &caps, VertexState &state) {
  state.fogFrom = queryFogFrom(query, caps);
  GLfloat factors[3] = {1, 0, 0};
  query.host.GetFloatv(GL_POINT_DISTANCE_ATTENUATION, factors);
  state.pointAttenuation = factors[0] != 1 || factors[1] != 0 || factors[2] != 0;
}

} // namespace

FogFrom queryFogFrom(const HostQuery &query, const HostCaps &caps) {
  if (query.name(GL_FOG_COORDINATE_SOURCE) != GL_FRAGMENT_DEPTH)
    return caps.foldsFogCoordinates ? FogFrom::AbsoluteCoordinate : FogFrom::Coordinate;
  switch (caps.fogDistance ? query.name(GL_FOG_DISTANCE_MODE_NV) : GL_EYE_PLANE_ABSOLUTE_NV) {
  case GL_EYE_RADIAL_NV:
    return FogFrom::Distance;
  case GL_EYE_PLANE:
    return FogFrom::Depth;
  default:
    return FogFrom::AbsoluteDepth;
  }
}

void Mirror::refreshVertexState(bool floatTarget) {
  constexpr std::uint32_t kGroups = dirty::kTransform | dirty::kLighting | dirty::kTexGen |
                                    dirty::kFog | dirty::kRaster | dirty::kPixelOps;
  const std::uint32_t groups = clock.changedSince(vertexSeen) & kGroups;
  vertexSeen = clock.now();
  const bool isClamped = clampVertexColors && !(clampVertexFixedOnly && floatTarget);
  const ColorClamp clamps = !isClamped              ? ColorClamp::None
                            : m_caps.clampsNanToOne ? ColorClamp::NanIsOne
                                                    : ColorClamp::NanIsZero;
  if (groups == 0 && clamps == vertex.clampColors) [[likely]]
    return;
  const VertexState before = vertex;
  VertexState &state = vertex;
  const HostQuery query{m_host};
  if ((groups & dirty::kTransform) != 0)
    queryTransform(m_caps, query, state);
  if ((groups & dirty::kLighting) != 0)
    queryLighting(query, state);
  if ((groups & dirty::kTexGen) != 0)
    queryTexGen(m_caps, query, state);
  if ((groups & (dirty::kFog | dirty::kRaster)) != 0)
    queryPointsAndFog(query, m_caps, state);
  state.clampColors = clamps;
  if (!(before == state))
    ++state.version;
}

} // namespace arbiter::state
