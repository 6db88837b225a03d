// The current raster position and what goes with it, by the slots of the attributes that it comes
// from.
#include <algorithm>
#include <bit>

#include "state/mirror/mirror.h"
#include "state/mirror/mirror_groups.h"

namespace arbiter::state::software {

namespace {

constexpr std::uint32_t kTexCoords = 0xFFu << kTexCoord0;

void queryValue(const HostCaps &caps, const HostQuery &query, int slot,
                std::array<float, 4> &value) {
  value = {0, 0, 0, 1};
  switch (slot) {
  case kColor:
    query.host.GetFloatv(GL_CURRENT_RASTER_COLOR, value.data());
    break;
  case kSecondary: // older hosts keep none, or do not tell
    if (caps.major > 2 || (caps.major == 2 && caps.minor >= 1))
      query.host.GetFloatv(GL_CURRENT_RASTER_SECONDARY_COLOR, value.data());
    break;
  case kFogCoord:
    value[0] = query.number(GL_CURRENT_RASTER_DISTANCE);
    break;
  default:
    break;
  }
}

} // namespace

void Mirror::refreshRasterPosition(std::uint32_t &dirty, std::uint32_t slots) {
  clock.take(dirty);
  const HostQuery query{m_host};
  if ((clock.changedSince(rasterSeen) & dirty::kRasterPosition) != 0) {
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
    queryValue(m_caps, query, slot, rasterValues[std::size_t(slot)]);
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

} // namespace arbiter::state::software
