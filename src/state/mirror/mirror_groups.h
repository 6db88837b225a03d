#pragma once
#include <cstdint>

#include "state/capabilities/host_caps.h"
#include "state/mirror/host_query.h"

/// The parts of mirror.cpp, one file each.
namespace arbiter::state {
class Mirror;
enum class FogFrom : std::uint8_t;

/// Moves the active texture unit for queries that name none, and restores it.
class UnitsScope {
public:
  explicit UnitsScope(const host::HostTable &host) : m_host(host) {
    m_host.GetIntegerv(GL_ACTIVE_TEXTURE, &m_first);
    m_selected = m_first;
  }
  ~UnitsScope() { choose(m_first); }
  UnitsScope(const UnitsScope &) = delete;
  UnitsScope &operator=(const UnitsScope &) = delete;
  void select(int unit) const { choose(GL_TEXTURE0 + unit); }

private:
  void choose(GLint name) const {
    if (m_selected != name)
      m_host.ActiveTexture(GLenum(m_selected = name));
  }
  const host::HostTable &m_host;
  GLint m_first = GL_TEXTURE0;
  mutable GLint m_selected = GL_TEXTURE0;
};

/// Queries alpha test, blending, depth and stencil tests, logic operation, masks and clamps.
void queryPixelOps(const HostCaps &caps, const HostQuery &query, Mirror &mirror);
/// Returns what the fog of fixed-function vertices is computed from.
[[nodiscard]] FogFrom queryFogFrom(const HostQuery &query, const HostCaps &caps);
/// Finds state that keeps all draws with the host. Call it after the other groups are queried.
void queryObstacles(const HostCaps &caps, const HostQuery &query, Mirror &mirror);
/// Queries the stipple: 32 rows of 4 bytes, the lowest first, the leftmost pixel in the highest
/// bit.
void queryPolygonStipple(const HostCaps &caps, const HostQuery &query, std::uint8_t rows[128]);

} // namespace arbiter::state
