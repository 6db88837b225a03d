#pragma once
#include <array>
#include <string>

#include <GL/gl.h>

#include "host/host_table.h"

namespace arbiter::state {

class Context;

namespace remote {

/// Pixels of a draw's target, y up.
struct Region {
  int x = 0, y = 0, width = 1, height = 1;
};

/// A framebuffer object of the layer's: colours of 32-bit floats and the depths of another
/// framebuffer, under names that no application makes. The context is current, outside Begin and
/// lists, wherever one of these functions is called.
class ProbeTarget {
public:
  static constexpr std::size_t kMostColors = 4;
  /// Of the two that there may be at a time in a context.
  enum class Use { Values, Depths };

  /// \param host the functions that draw (not those that are observed)
  ProbeTarget(Context &context, const host::HostTable &host, Use use);
  ~ProbeTarget();
  ProbeTarget(const ProbeTarget &) = delete;
  ProbeTarget &operator=(const ProbeTarget &) = delete;

  [[nodiscard]] GLuint name() const { return m_framebuffer; }
  /// Bound for drawing, with so many colours, and depths of a format, or none (0); what they hold
  /// is undefined. False: the host has no such framebuffer.
  [[nodiscard]] bool attach(std::size_t colors, const Region &region, GLenum depthFormat = 0);
  /// attach() with the format of another framebuffer's depths, and these in the region. No scissor
  /// test is enabled. \returns an empty string, or why not
  [[nodiscard]] std::string attachDepthsOf(GLuint source, std::size_t colors, const Region &region);
  /// Again, after attachDepthsOf(), of another part of the region. The object is bound for drawing.
  void copyDepths(GLuint source, const Region &part);
  [[nodiscard]] bool hasStencil() const;

private:
  void image(std::size_t index, int width, int height, GLenum format);

  Context &m_context;
  const host::HostTable &m_host;
  const GLuint m_framebuffer, m_firstTexture;
  GLenum m_depthFormat = 0; ///< of the last attachDepthsOf()
  bool m_made = false;
};

/// Whether the framebuffer that is bound for drawing has depths, and stencils; without, their tests
/// pass.
struct HasDepths {
  explicit HasDepths(const host::HostTable &host);
  bool depth = false, stencil = false;
};

/// The size of an application's framebuffer object that is bound for drawing. False: it has no
/// attachment whose size is known.
[[nodiscard]] bool framebufferSize(Context &context, const host::HostTable &host, int &width,
                                   int &height);

/// What is bound to draw and to read from, and all attributes, are put back at its end. Requires
/// room for one entry on the attribute stack.
class TargetScope {
public:
  explicit TargetScope(const host::HostTable &host);
  ~TargetScope();
  TargetScope(const TargetScope &) = delete;
  TargetScope &operator=(const TargetScope &) = delete;

private:
  const host::HostTable &m_host;
  GLint m_read = 0, m_draw = 0;
};

/// Of a region what the application lets be drawn: its scissor box, and the region. False: nothing.
[[nodiscard]] bool limitTo(const host::HostTable &host, const Region &region);

} // namespace remote
} // namespace arbiter::state
