#pragma once
#include "common/image.h"
#include <epoxy/gl.h>
#include <memory>
#include <string>

struct GLFWwindow;

namespace demos {

/// The target of a demo's drawing, with its compatibility context current.
class Surface {
public:
  virtual ~Surface() = default;
  Surface() = default;
  Surface(const Surface &) = delete;
  Surface &operator=(const Surface &) = delete;

  [[nodiscard]] int width() const { return m_width; }
  [[nodiscard]] int height() const { return m_height; }
  /// Returns the buffer that is drawn to, for glReadBuffer.
  [[nodiscard]] virtual GLenum colorBuffer() const = 0;
  /// Shows the frame if there is a window.
  virtual void present() = 0;
  /// Returns null without a window.
  [[nodiscard]] virtual GLFWwindow *window() const { return nullptr; }

  /// Reads the picture; call it before present().
  [[nodiscard]] Image readPixels() const;

protected:
  int m_width = 0;
  int m_height = 0;
};

/// Creates an EGL surface without a display server. It draws to a framebuffer object, or to a
/// pbuffer's default framebuffer. It tries a GPU's device first, then Mesa's surfaceless platform,
/// then a software device. Returns null, after a message on stderr, if there is no such context.
[[nodiscard]] std::unique_ptr<Surface> makeHeadless(int width, int height, bool pbuffer);

/// Creates a GLFW window. Returns null, after a message on stderr, if there is no display.
[[nodiscard]] std::unique_ptr<Surface> makeWindow(int width, int height, const std::string &title);

} // namespace demos
