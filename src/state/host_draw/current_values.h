#pragma once
#include <array>

#include <GL/gl.h>

#include "host/host_table.h"

namespace arbiter::state {

/// Makes the host apply its current values now. Mesa 22.3.6 defers this to the next draw or query:
/// it then uses the COLOR_MATERIAL of that time, and overwrites what PopAttrib restored. An
/// application draws in between; if the rasterizer does that draw, the host does not see it.
inline void settleCurrentValues(const host::HostTable &host) {
  std::array<GLfloat, 4> color{};
  host.GetFloatv(GL_CURRENT_COLOR, color.data());
}

} // namespace arbiter::state
