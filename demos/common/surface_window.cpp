#include "common/surface.h"

#include <cstdio>
// This include must follow epoxy's: GLFW then does not include GL headers.
#include <GLFW/glfw3.h>

namespace demos {
namespace {

class WindowSurface final : public Surface {
public:
  ~WindowSurface() override {
    if (m_window)
      glfwDestroyWindow(m_window);
    glfwTerminate();
  }

  [[nodiscard]] bool open(int width, int height, const std::string &title) {
    glfwSetErrorCallback([](int, const char *text) { std::fprintf(stderr, "GLFW: %s\n", text); });
    if (!glfwInit())
      return false;
    // Pictures are compared and fed back pixel by pixel, so that the size must not change.
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    glfwWindowHint(GLFW_DEPTH_BITS, 24);
    m_window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (!m_window)
      return false;
    glfwMakeContextCurrent(m_window);
    glfwSwapInterval(1);
    glfwGetFramebufferSize(m_window, &m_width, &m_height);
    return true;
  }

  [[nodiscard]] GLenum colorBuffer() const override { return GL_BACK; }
  void present() override {
    glfwSwapBuffers(m_window);
    glfwPollEvents();
  }
  [[nodiscard]] GLFWwindow *window() const override { return m_window; }

private:
  GLFWwindow *m_window = nullptr;
};

} // namespace

std::unique_ptr<Surface> makeWindow(int width, int height, const std::string &title) {
  auto surface = std::make_unique<WindowSurface>();
  if (surface->open(width, height, title))
    return surface;
  std::fprintf(stderr, "no window: is there a display? `--headless --out FILE.png` needs none\n");
  return nullptr;
}

} // namespace demos
