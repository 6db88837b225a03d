#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "state/control/draw_probe.h"
#include "state/control/probe_target.h"

namespace arbiter::state::control {

/// A copy of the window's depths and stencils for a few pixels, made by repeating the frame's draws
/// in a framebuffer object. Depths in an object may differ from a window's in the last bits (Mesa
/// stores their rows in opposite order). A draw that tests depths for equality would then find
/// others. The window's values are taken where something other than these draws has written them.
class DepthReplica {
public:
  /// \param host functions that draw without being observed
  DepthReplica(RasterContext &context, const host::HostTable &host, const Region &region)
      : m_context(context), m_host(host), m_region(region),
        m_target(context, host, ProbeTarget::Use::Depths) {}

  /// Takes over the window's values where they differ by more than rounding. Called before a draw
  /// to the window that tests depths or stencils.
  /// \returns an empty string, or why the values are not available
  [[nodiscard]] std::string meet();
  /// Repeats the draw here, after it.
  void follow(const Redraw &redraw);
  /// True if all of a region is available, after meet().
  [[nodiscard]] bool holds(const Region &region) const;
  [[nodiscard]] GLuint framebuffer() const { return m_target.name(); }

private:
  struct Value {
    float depth = 0;
    std::uint32_t stencil = 0;
  };
  [[nodiscard]] std::vector<Value> read(GLuint framebuffer) const;

  RasterContext &m_context;
  const host::HostTable &m_host;
  const Region m_region;
  ProbeTarget m_target;
  bool m_known = false;
};

} // namespace arbiter::state::control
