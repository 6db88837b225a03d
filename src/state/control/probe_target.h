#pragma once
#include <array>
#include <string>

#include <GL/gl.h>

#include "host/host_table.h"

namespace arbiter::state {

struct RasterContext;

namespace control {

/// Pixels of a draw's target, y up.
struct Region {
  int x = 0, y = 0, width = 1, height = 1;
};

/// A framebuffer object of the layer's with 32-bit float colours and depths copied from another
/// framebuffer, under names that no application uses. Its functions require that the context is
/// current, outside Begin and lists.
class ProbeTarget {
public:
  static constexpr std::size_t kMaxColors = 4;
  /// Selects the names, as a context may have two objects at a time.
  enum class Use { Values, Depths };

  /// \param host functions that draw without being observed
  ProbeTarget(RasterContext &context, const host::HostTable &host, Use use);
  ~ProbeTarget();
  ProbeTarget(const ProbeTarget &) = delete;
  ProbeTarget &operator=(const ProbeTarget &) = delete;

  [[nodiscard]] GLuint name() const { return m_framebuffer; }
  /// Binds the object for drawing with `colors` colours and depths of a format, or none (0). The
  /// contents are undefined. Returns false if the host has no such framebuffer.
  [[nodiscard]] bool attach(std::size_t colors, const Region &region, GLenum depthFormat = 0);
  /// Attaches with the format of another framebuffer's depths, and copies these in the region. The
  /// scissor test must be off. \returns an empty string, or why it fails
  [[nodiscard]] std::string attachDepthsOf(GLuint source, std::size_t colors, const Region &region);
  /// Copies a part of the region again, after attachDepthsOf(). The object must be bound for
  /// drawing.
  void copyDepths(GLuint source, const Region &part);
  [[nodiscard]] bool hasStencil() const;

private:
  void image(std::size_t index, int width, int height, GLenum format);

  RasterContext &m_context;
  const host::HostTable &m_host;
  const GLuint m_framebuffer, m_firstTexture;
  GLenum m_depthFormat = 0; ///< of the last attachDepthsOf()
  bool m_made = false;
};

/// Tells whether the draw framebuffer has depths and stencils. Without them, their tests pass.
struct HasDepths {
  explicit HasDepths(const host::HostTable &host);
  bool depth = false, stencil = false;
};

/// Gets the size of the application's framebuffer object that is bound for drawing. Returns false
/// if no attachment's size is known.
[[nodiscard]] bool framebufferSize(RasterContext &context, const host::HostTable &host, int &width,
                                   int &height);

/// Restores the draw and read framebuffers and all attributes at its end. Requires room for one
/// entry on the attribute stack.
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

/// Sets the scissor to the region and the application's scissor box. Returns false if that is
/// empty.
[[nodiscard]] bool limitTo(const host::HostTable &host, const Region &region);

} // namespace control
} // namespace arbiter::state
