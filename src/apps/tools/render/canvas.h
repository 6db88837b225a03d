#pragma once
#include <epoxy/gl.h>

namespace arbiter::tools {

/// The framebuffer object for documents, with color, depth and stencil of one size.
class Canvas {
public:
  Canvas() = default;
  Canvas(const Canvas &) = delete;
  Canvas &operator=(const Canvas &) = delete;
  ~Canvas();

  /// Makes it the current framebuffer in that size. False if GL does not support it.
  [[nodiscard]] bool use(int width, int height);

private:
  int m_width = 0, m_height = 0;
  GLuint m_framebuffer = 0, m_buffers[2] = {0, 0};
};

} // namespace arbiter::tools
