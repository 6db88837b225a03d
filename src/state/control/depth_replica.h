#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "state/control/draw_probe.h"
#include "state/control/probe_target.h"

namespace arbiter::state::remote {

/// The window's depths and stencils in a few pixels, as draws to a framebuffer object make them.
/// What is drawn to an object need not have the last bits that it has in a window (whose rows lie
/// the other way up in memory, in Mesa): a draw that compares its depths with the window's for
/// equality, or passes where they are equal, would find others. So the frame's draws are made here
/// too, and the window's values taken where something else has written them.
class DepthReplica {
public:
  /// \param host the functions that draw (not those that are observed)
  DepthReplica(Context &context, const host::HostTable &host, const Region &region)
      : m_context(context), m_host(host), m_region(region),
        m_target(context, host, ProbeTarget::Use::Depths) {}

  /// Before a draw to the window that tests depths or stencils: pixels whose value is another than
  /// the window's, by more than what rounding makes, become the window's.
  /// \returns an empty string, or why they cannot be had
  [[nodiscard]] std::string meet();
  /// Behind it: what the draw makes of them.
  void follow(const Redraw &redraw);
  /// After meet(): whether it has all of a region.
  [[nodiscard]] bool holds(const Region &region) const;
  [[nodiscard]] GLuint framebuffer() const { return m_target.name(); }

private:
  struct Value {
    float depth = 0;
    std::uint32_t stencil = 0;
  };
  [[nodiscard]] std::vector<Value> read(GLuint framebuffer) const;

  Context &m_context;
  const host::HostTable &m_host;
  const Region m_region;
  ProbeTarget m_target;
  bool m_known = false;
};

} // namespace arbiter::state::remote
