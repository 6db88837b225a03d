#pragma once
#include "common/image.h"
#include <epoxy/gl.h>
#include <memory>
#include <string>

struct GLFWwindow;

namespace demos {

/// What a demo draws to, with its compatibility context current.
class Surface {
public:
  virtual ~Surface() = default;
  Surface() = default;
  Surface(const Surface &) = delete;
  Surface &operator=(const Surface &) = delete;

  [[nodiscard]] int width() const { return m_width; }
  [[nodiscard]] int height() const { return m_height; }
  /// For glReadBuffer: the buffer that is drawn to.
  [[nodiscard]] virtual GLenum colourBuffer() const = 0;
  /// Shows the frame, if there is anyone to see it.
  virtual void present() = 0;
  /// Null without a window.
  [[nodiscard]] virtual GLFWwindow *window() const { return nullptr; }

  /// Reads the picture; call before present().
  [[nodiscard]] Image readPixels() const;

protected:
  int m_width = 0;
  int m_height = 0;
};

/// EGL without a display server, drawing to a framebuffer object, or to a pbuffer's default
/// framebuffer. Looks for a GPU's device first, then for Mesa's surfaceless platform, then for a
/// software device. Null, after a message on stderr, if there is no such context.
[[nodiscard]] std::unique_ptr<Surface> makeHeadless(int width, int height, bool pbuffer);

/// A GLFW window. Null, after a message on stderr, if there is no display.
[[nodiscard]] std::unique_ptr<Surface> makeWindow(int width, int height, const std::string &title);

} // namespace demos
