// Current vertex attributes, by slots.
#include <algorithm>
#include <bit>

#include "state/context.h"
#include "state/software/mirror.h"
#include "state/software/mirror_groups.h"

namespace arbiter::state::software {

namespace {

constexpr std::uint32_t kTexCoords = 0xFFu << kTexCoord0;

void askSlot(const HostCaps &caps, const Ask &ask, int slot, std::array<float, 4> &value) {
  value = {0, 0, 0, 1};
  switch (slot) {
  case kPosition:
    break; // there is none
  case kNormal:
    ask.host.GetFloatv(GL_CURRENT_NORMAL, value.data());
    break;
  case kColor:
    ask.host.GetFloatv(GL_CURRENT_COLOR, value.data());
    break;
  case kSecondary:
    ask.host.GetFloatv(GL_CURRENT_SECONDARY_COLOR, value.data());
    break;
  case kFogCoord:
    ask.host.GetFloatv(GL_CURRENT_FOG_COORDINATE, value.data());
    break;
  case kEdgeFlag:
    value[0] = ask.boolean(GL_EDGE_FLAG) ? 1.0f : 0.0f;
    break;
  default:
    if (slot >= kGeneric0 && slot - kGeneric0 < caps.maxVertexAttribs)
      ask.host.GetVertexAttribfv(GLuint(slot - kGeneric0), GL_CURRENT_VERTEX_ATTRIB, value.data());
    break;
  }
}

} // namespace

void refreshCurrent(Context &context, Mirror &mirror, std::uint32_t slots) {
  mirror.clock.take(context);
  if ((mirror.clock.changedSince(mirror.currentSeen) & stale::kCurrent) != 0)
    mirror.currentKnown = 0;
  mirror.currentSeen = mirror.clock.now();
  const std::uint32_t wanted = slots & ~mirror.currentKnown & ~(1u << kGeneric0);
  if (wanted == 0) [[likely]]
    return;
  const Ask ask{*context.host};
  for (std::uint32_t left = wanted & ~kTexCoords; left != 0; left &= left - 1) {
    const int slot = std::countr_zero(left);
    askSlot(context.caps, ask, slot, mirror.current[std::size_t(slot)]);
  }
  if ((wanted & kTexCoords) != 0) {
    const UnitsScope units(*context.host);
    for (std::uint32_t left = wanted & kTexCoords; left != 0; left &= left - 1) {
      const int slot = std::countr_zero(left);
      std::array<float, 4> &value = mirror.current[std::size_t(slot)];
      value = {0, 0, 0, 1};
      if (slot - kTexCoord0 >= context.caps.maxTextureCoords)
        continue;
      units.select(slot - kTexCoord0);
      ask.host.GetFloatv(GL_CURRENT_TEXTURE_COORDS, value.data());
    }
  }
  mirror.currentKnown |= wanted;
}

void noteCurrent(Mirror &mirror, const CurrentValues &values, std::uint32_t slots) {
  for (std::uint32_t left = slots; left != 0; left &= left - 1) {
    const int slot = std::countr_zero(left);
    mirror.current[std::size_t(slot)] = values[std::size_t(slot)];
  }
  mirror.currentKnown |= slots;
  if ((slots & 1u << kColor) == 0 || !mirror.vertex.colorMaterial) [[likely]]
    return;
  // The material followed the colour.
  const bool upToDate = (mirror.clock.changedSince(mirror.currentSeen) & stale::kCurrent) == 0;
  mirror.clock.mark(stale::kCurrent);
  if (upToDate)
    mirror.currentSeen = mirror.clock.now();
}

} // namespace arbiter::state::software
