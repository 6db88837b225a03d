#pragma once
#include <GL/gl.h>

#include "host/host_table.h"

namespace arbiter::state {

/// What the host answers to GetIntegerv of one value; 0 where it answers nothing.
[[nodiscard]] inline GLint hostInteger(const host::HostTable &host, GLenum name) {
  GLint value = 0;
  host.GetIntegerv(name, &value);
  return value;
}

} // namespace arbiter::state
