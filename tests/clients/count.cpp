/// Issues a known number of glClear and glDrawArrays calls: argv[1] times, on the EGL platform
/// argv[2] ("device", "surfaceless", or the default), half by the linked name, half by pointer.
#include <cstdlib>
#include <cstring>

#define GL_GLEXT_PROTOTYPES
#include "body.h"
#include "egl_surface.h"

using namespace clients;

int main(int argc, char **argv) {
  const int calls = argc > 1 ? std::atoi(argv[1]) : 1000;
  const char *const where = argc > 2 ? argv[2] : "";
  Egl egl;
#define X(name) egl.name = ::egl##name;
  CLIENT_EGL_FUNCTIONS(X)
#undef X
  EglSurface surface =
      openSurface(egl, !std::strcmp(where, "device")        ? EGL_PLATFORM_DEVICE_EXT
                       : !std::strcmp(where, "surfaceless") ? EGL_PLATFORM_SURFACELESS_MESA
                                                            : 0);
  const auto clear = reinterpret_cast<decltype(&::glClear)>(eglGetProcAddress("glClear"));
  const auto draw = reinterpret_cast<decltype(&::glDrawArrays)>(eglGetProcAddress("glDrawArrays"));
  for (int i = 0; i < calls; ++i) {
    if (i % 2) {
      clear(GL_COLOR_BUFFER_BIT);
      draw(GL_POINTS, 0, 0);
    } else {
      glClear(GL_COLOR_BUFFER_BIT);
      glDrawArrays(GL_POINTS, 0, 0);
    }
  }
  glFinish();
  const bool right = glGetError() == GL_NO_ERROR;
  closeSurface(egl, surface);
  return right ? 0 : 1;
}
