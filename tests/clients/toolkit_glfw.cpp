/// Uses GLFW; argv[1] "egl" makes the context through EGL, else through GLX.
#include <cstring>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "body.h"

int main(int argc, char **argv) {
  using namespace clients;
  if (!glfwInit())
    die("glfwInit");
  const bool egl = argc > 1 && !std::strcmp(argv[1], "egl");
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, egl ? GLFW_EGL_CONTEXT_API : GLFW_NATIVE_CONTEXT_API);
  GLFWwindow *const window = glfwCreateWindow(64, 64, "client", nullptr, nullptr);
  if (!window)
    die("glfwCreateWindow");
  glfwMakeContextCurrent(window);
  const bool right = drawAndReport(
      load([](const char *name) { return reinterpret_cast<void *>(glfwGetProcAddress(name)); }),
      egl ? "glfw_egl" : "glfw_glx");
  glfwSwapBuffers(window);
  glfwDestroyWindow(window);
  glfwTerminate();
  return right ? 0 : 1;
}
