// Queries current vertex attributes, by slot.
#include <algorithm>
#include <bit>

#include "state/mirror/mirror.h"
#include "state/mirror/mirror_groups.h"

namespace arbiter::state {

namespace {

void querySlot(const HostCaps &caps, const HostQuery &query, int slot,
               std::array<float, 4> &value) {
  value = {0, 0, 0, 1};
  switch (slot) {
  case kPosition:
    break; // the position has no current value
  case kNormal:
    query.host.GetFloatv(GL_CURRENT_NORMAL, value.data());
    break;
  case kColor:
    query.host.GetFloatv(GL_CURRENT_COLOR, value.data());
    break;
  case kSecondary:
    query.host.GetFloatv(GL_CURRENT_SECONDARY_COLOR, value.data());
    break;
  case kFogCoord:
    query.host.GetFloatv(GL_CURRENT_FOG_COORDINATE, value.data());
    break;
  case kEdgeFlag:
    value[0] = query.boolean(GL_EDGE_FLAG) ? 1.0f : 0.0f;
    break;
  default:
    if (slot >= kGeneric0 && slot - kGeneric0 < caps.maxVertexAttribs)
      query.host.GetVertexAttribfv(GLuint(slot - kGeneric0), GL_CURRENT_VERTEX_ATTRIB,
                                   value.data());
    break;
  }
}

} // namespace

void Mirror::refreshCurrent(std::uint32_t &dirty, std::uint32_t slots) {
  clock.take(dirty);
  if ((clock.changedSince(currentSeen) & dirty::kCurrent) != 0)
    currentKnown = 0;
  currentSeen = clock.now();
  const std::uint32_t wanted = slots & ~currentKnown & ~(1u << kGeneric0);
  if (wanted == 0) [[likely]]
    return;
  const HostQuery query{m_host};
  for (std::uint32_t left = wanted & ~kTexCoords; left != 0; left &= left - 1) {
    const int slot = std::countr_zero(left);
    querySlot(m_caps, query, slot, current[std::size_t(slot)]);
  }
  if ((wanted & kTexCoords) != 0) {
    const UnitsScope units(m_host);
    for (std::uint32_t left = wanted & kTexCoords; left != 0; left &= left - 1) {
      const int slot = std::countr_zero(left);
      std::array<float, 4> &value = current[std::size_t(slot)];
      value = {0, 0, 0, 1};
      if (slot - kTexCoord0 >= m_caps.maxTextureCoords)
        continue;
      units.select(slot - kTexCoord0);
      query.host.GetFloatv(GL_CURRENT_TEXTURE_COORDS, value.data());
    }
  }
  currentKnown |= wanted;
}

void Mirror::noteCurrent(const CurrentValues &values, std::uint32_t slots) {
  for (std::uint32_t left = slots; left != 0; left &= left - 1) {
    const int slot = std::countr_zero(left);
    current[std::size_t(slot)] = values[std::size_t(slot)];
  }
  currentKnown |= slots;
  if ((slots & 1u << kColor) == 0 || !vertex.colorMaterial) [[likely]]
    return;
  // The material has followed the colour.
  const bool upToDate = (clock.changedSince(currentSeen) & dirty::kCurrent) == 0;
  clock.mark(dirty::kCurrent);
  if (upToDate)
    currentSeen = clock.now();
}

} // namespace arbiter::state
