#pragma once
#include <GL/gl.h>

#include "host/host_table.h"

namespace arbiter::state {

/// Returns one value of the host's GetIntegerv; 0 if the host sets none.
[[nodiscard]] inline GLint hostInteger(const host::HostTable &host, GLenum name) {
  GLint value = 0;
  host.GetIntegerv(name, &value);
  return value;
}

/// Returns one value of the texture environment of the host's active unit.
[[nodiscard]] inline GLint hostEnvironment(const host::HostTable &host, GLenum name) {
  GLint value = 0;
  host.GetTexEnviv(GL_TEXTURE_ENV, name, &value);
  return value;
}

} // namespace arbiter::state
