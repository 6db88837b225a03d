// Queries the current raster position and its values, by the slots of the attributes that set them.
#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "state/mirror/mirror.h"
#include "state/mirror/mirror_groups.h"

namespace arbiter::state {

namespace {

/// Returns the eye z of a raster position, by transforming its clip coordinates back through the
/// projection. Hosts keep only its distance to the eye. |z| cannot exceed that, so the result is
/// clamped in case the projection or viewport has changed since.
float eyeDepth(const HostQuery &query, const RasterPosition &raster, float distance) {
  GLint viewport[4] = {};
  GLfloat range[2] = {0, 1};
  glm::mat4 projection(1.0f);
  query.host.GetIntegerv(GL_VIEWPORT, viewport);
  query.host.GetFloatv(GL_DEPTH_RANGE, range);
  query.host.GetFloatv(GL_PROJECTION_MATRIX, &projection[0][0]);
  const glm::dmat4 matrix(projection);
  if (viewport[2] == 0 || viewport[3] == 0 || range[0] == range[1] ||
      glm::determinant(matrix) == 0.0)
    return distance;
  const float *const at = raster.position;
  const glm::dvec4 device((double(at[0]) - viewport[0]) * 2 / viewport[2] - 1,
                          (double(at[1]) - viewport[1]) * 2 / viewport[3] - 1,
                          (double(at[2]) - range[0]) * 2 / (double(range[1]) - range[0]) - 1, 1);
  const auto z = float((glm::inverse(matrix) * (device * double(at[3]))).z);
  return std::clamp(z, -distance, distance);
}

/// Returns the fog coordinate of fragments at the raster position. It equals that of a vertex
/// there: the raster distance may be approximated like a vertex's (OpenGL 2.1, 2.13, 3.10).
float fogCoordinate(const HostCaps &caps, const HostQuery &query, const RasterPosition &raster) {
  const float distance = query.number(GL_CURRENT_RASTER_DISTANCE);
  switch (queryFogFrom(query, caps)) {
  case FogFrom::AbsoluteDepth:
    return std::abs(eyeDepth(query, raster, std::abs(distance)));
  case FogFrom::Depth:
    return eyeDepth(query, raster, std::abs(distance));
  case FogFrom::AbsoluteCoordinate:
    return std::abs(distance);
  case FogFrom::Coordinate:
  case FogFrom::Distance:
    break;
  }
  return distance;
}

void queryValue(const HostCaps &caps, const HostQuery &query, int slot,
                const RasterPosition &raster, std::array<float, 4> &value) {
  value = {0, 0, 0, 1};
  switch (slot) {
  case kColor:
    query.host.GetFloatv(GL_CURRENT_RASTER_COLOR, value.data());
    break;
  case kSecondary: // older hosts keep none, or cannot be asked
    if (caps.major > 2 || (caps.major == 2 && caps.minor >= 1))
      query.host.GetFloatv(GL_CURRENT_RASTER_SECONDARY_COLOR, value.data());
    break;
  case kFogCoord:
    value[0] = fogCoordinate(caps, query, raster);
    break;
  default:
    break;
  }
}

} // namespace

void Mirror::refreshRasterPosition(std::uint32_t &dirty, std::uint32_t slots) {
  clock.take(dirty);
  const HostQuery query{m_host};
  const std::uint32_t changed = clock.changedSince(rasterSeen);
  if ((changed & dirty::kFog) != 0)
    rasterValuesKnown &= ~(1u << kFogCoord);
  if ((changed & dirty::kRasterPosition) != 0) {
    rasterValuesKnown = 0;
    rasterPosition.valid = query.boolean(GL_CURRENT_RASTER_POSITION_VALID);
    query.host.GetFloatv(GL_CURRENT_RASTER_POSITION, rasterPosition.position);
  }
  rasterSeen = clock.now();
  const std::uint32_t wanted = slots & ~rasterValuesKnown;
  if (wanted == 0 || !rasterPosition.valid) [[likely]]
    return;
  for (std::uint32_t left = wanted & ~kTexCoords; left != 0; left &= left - 1) {
    const int slot = std::countr_zero(left);
    queryValue(m_caps, query, slot, rasterPosition, rasterValues[std::size_t(slot)]);
  }
  if ((wanted & kTexCoords) != 0) {
    const UnitsScope units(m_host);
    for (std::uint32_t left = wanted & kTexCoords; left != 0; left &= left - 1) {
      const int slot = std::countr_zero(left);
      std::array<float, 4> &value = rasterValues[std::size_t(slot)];
      value = {0, 0, 0, 1};
      if (slot - kTexCoord0 >= m_caps.maxTextureCoords)
        continue;
      units.select(slot - kTexCoord0);
      query.host.GetFloatv(GL_CURRENT_RASTER_TEXTURE_COORDS, value.data());
    }
  }
  rasterValuesKnown |= wanted;
}

} // namespace arbiter::state
