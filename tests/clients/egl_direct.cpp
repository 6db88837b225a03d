/// Is linked with libEGL and libOpenGL. An argument "device" or "surfaceless" selects the platform.
#include <cstring>

#define GL_GLEXT_PROTOTYPES
#include "body.h"
#include "egl_surface.h"

using namespace clients;

namespace {

void *getProc(const char *name) { return reinterpret_cast<void *>(eglGetProcAddress(name)); }

} // namespace

int main(int argc, char **argv) {
  Egl egl;
#define X(name) egl.name = ::egl##name;
  CLIENT_EGL_FUNCTIONS(X)
#undef X
  Gl gl;
#define X(name, result, parameters) gl.name = ::gl##name;
  CLIENT_GL_FUNCTIONS(X)
#undef X
  EGLenum platform = 0;
  if (argc > 1 && !std::strcmp(argv[1], "device"))
    platform = EGL_PLATFORM_DEVICE_EXT;
  if (argc > 1 && !std::strcmp(argv[1], "surfaceless"))
    platform = EGL_PLATFORM_SURFACELESS_MESA;
  EglSurface surface = openSurface(egl, platform);
  loadArb(gl, getProc);
  const bool right = drawAndReport(gl, "egl_direct");
  closeSurface(egl, surface);
  return right ? 0 : 1;
}
