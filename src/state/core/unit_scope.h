#pragma once
#include "host/host_table.h"

namespace arbiter::state {

/// Selects a texture unit for queries that name none, and restores the old one.
class UnitScope {
public:
  UnitScope(const host::HostTable &host, GLuint unit) : m_host(host) {
    m_host.GetIntegerv(GL_ACTIVE_TEXTURE, &m_previous);
    m_changed = GLuint(m_previous) != GL_TEXTURE0 + unit;
    if (m_changed)
      m_host.ActiveTexture(GL_TEXTURE0 + unit);
  }
  ~UnitScope() {
    if (m_changed)
      m_host.ActiveTexture(GLenum(m_previous));
  }
  UnitScope(const UnitScope &) = delete;
  UnitScope &operator=(const UnitScope &) = delete;

private:
  const host::HostTable &m_host;
  GLint m_previous = GL_TEXTURE0;
  bool m_changed = false;
};

} // namespace arbiter::state
