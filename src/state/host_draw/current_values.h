#pragma once
#include <array>

#include <GL/gl.h>

#include "host/host_table.h"

namespace arbiter::state {

/// Has the host take current values into its state. Mesa 22.3.6 does that at the next draw or
/// question: by the COLOR_MATERIAL of then, and over what PopAttrib has restored. An application
/// draws in between; where the rasterizer does, the host does not.
inline void settleCurrentValues(const host::HostTable &host) {
  std::array<GLfloat, 4> color{};
  host.GetFloatv(GL_CURRENT_COLOR, color.data());
}

} // namespace arbiter::state
