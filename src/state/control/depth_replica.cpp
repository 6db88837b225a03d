#include "state/control/depth_replica.h"

#include <cmath>

#include "state/control/host_pixels.h"
#include "state/core/host_errors.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state::control {

namespace {

/// The tolerance of depths. On a plane that is steep in the window, the terms of a depth are many
/// times the depth, and so is their rounding error.
constexpr float kRounding = 0x1p-16f;

} // namespace

std::vector<DepthReplica::Value> DepthReplica::read(GLuint framebuffer) const {
  const Region &r = m_region;
  const std::size_t count = std::size_t(r.width) * std::size_t(r.height);
  std::vector<float> depths(count);
  std::vector<GLuint> stencils(count);
  m_host.BindFramebufferEXT(GL_READ_FRAMEBUFFER, framebuffer);
  const PlainTransfer plain(m_context, PixelStore::Pack);
  m_host.ReadPixels(r.x, r.y, r.width, r.height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  if (m_target.hasStencil())
    m_host.ReadPixels(r.x, r.y, r.width, r.height, GL_STENCIL_INDEX, GL_UNSIGNED_INT,
                      stencils.data());
  std::vector<Value> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] = {depths[i], stencils[i]};
  return values;
}

std::string DepthReplica::meet() {
  const HostErrorScope errors(m_host, m_context.errors.pending);
  const TargetScope state(m_host);
  m_host.Disable(GL_SCISSOR_TEST);
  if (!m_known) {
    std::string why = m_target.attachDepthsOf(0, 1, m_region); // a colour, for the alpha test
    m_known = why.empty();
    return why;
  }
  const std::vector<Value> window = read(0), own = read(m_target.name());
  m_host.BindFramebufferEXT(GL_DRAW_FRAMEBUFFER, m_target.name());
  for (std::size_t i = 0; i < own.size(); ++i) {
    const bool meets = std::abs(own[i].depth - window[i].depth) <= kRounding &&
                       own[i].stencil == window[i].stencil;
    if (!meets)
      m_target.copyDepths(
          0, {m_region.x + int(i) % m_region.width, m_region.y + int(i) / m_region.width, 1, 1});
  }
  return {};
}

void DepthReplica::follow(const Redraw &redraw) {
  const HostErrorScope errors(m_host, m_context.errors.pending);
  const TargetScope state(m_host);
  m_host.BindFramebufferEXT(GL_DRAW_FRAMEBUFFER, m_target.name());
  if (limitTo(m_host, m_region))
    redraw(m_host);
}

bool DepthReplica::holds(const Region &region) const {
  return m_known && region.x >= m_region.x && region.y >= m_region.y &&
         region.x + region.width <= m_region.x + m_region.width &&
         region.y + region.height <= m_region.y + m_region.height;
}

} // namespace arbiter::state::control
