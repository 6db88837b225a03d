#pragma once
#include <epoxy/gl.h>
#include <string>
#include <vector>

#include "apps/tools/debug/pixel/drawer.h"

namespace arbiter::tools::debug {

/// A framebuffer object with up to kMaxTargets colors, depth and stencil. The debugger draws
/// probes into such objects. It also draws the document's own picture into one if passes test each
/// other's depths. The reason is that a window's rows may be stored in the opposite order, which
/// changes the last bit of a depth.
class DrawTarget {
public:
  /// \param format of the color attachments
  explicit DrawTarget(GLenum format = GL_RGBA32F) : m_format(format) {}
  DrawTarget(const DrawTarget &) = delete;
  DrawTarget &operator=(const DrawTarget &) = delete;

  /// Binds a framebuffer of at least that size with `targets` draw buffers. One object serves all
  /// numbers of targets, because clearing attachments that were drawn to before is cheaper.
  /// \returns an empty string, or why the framebuffer could not be made
  [[nodiscard]] std::string bind(int width, int height, std::size_t targets);
  /// Binds it for reading. Requires: bind() was successful.
  void bindToRead() const { glBindFramebuffer(GL_READ_FRAMEBUFFER, m_framebuffer); }
  /// Sets every pixel to uncovered(), without a scissor test. Keeps the clear color.
  void clear() const;
  /// Reads targets * height * width values from the bound framebuffer. Requires: a float format.
  [[nodiscard]] std::vector<fp::ir::Vec4> read(const Region &region) const;

private:
  void release();

  const GLenum m_format;
  GLuint m_framebuffer = 0, m_depth = 0;
  std::vector<GLuint> m_colors;
  std::size_t m_drawn = 0; ///< number of m_colors that are draw buffers
  int m_width = 0, m_height = 0;
};

} // namespace arbiter::tools::debug
