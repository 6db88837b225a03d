#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

#include "host/host_table.h"

namespace arbiter::state {

/// Queries of the host that return values.
struct HostQuery {
  const host::HostTable &host;

  [[nodiscard]] bool enabled(GLenum cap) const { return host.IsEnabled(cap) != GL_FALSE; }
  [[nodiscard]] GLint integer(GLenum pname) const {
    GLint value = 0;
    host.GetIntegerv(pname, &value);
    return value;
  }
  [[nodiscard]] GLenum name(GLenum pname) const { return GLenum(integer(pname)); }
  [[nodiscard]] bool boolean(GLenum pname) const { return integer(pname) != 0; }
  [[nodiscard]] float number(GLenum pname) const {
    GLfloat value = 0;
    host.GetFloatv(pname, &value);
    return value;
  }
};

/// Keeps the first reason why draws stay with the host.
inline void refuse(const char *&obstacle, const char *&detail, const char *reason,
                   const char *what) {
  if (obstacle)
    return;
  obstacle = reason;
  detail = what;
}

} // namespace arbiter::state
