/// A library that makes a context and draws in its constructor, before main and before the
/// constructor of anything preloaded.
#include <dlfcn.h>

#define GL_GLEXT_PROTOTYPES
#include "body.h"
#include "egl_surface.h"

using namespace clients;

namespace {

bool g_right = false;

void *getProc(const char *name) { return reinterpret_cast<void *>(eglGetProcAddress(name)); }

[[gnu::constructor]] void drawEarly() {
  // Without a context a call must have no effect and not end the process.
  glEnable(GL_BLEND);
  glGetError();
  Egl egl;
#define X(name) egl.name = ::egl##name;
  CLIENT_EGL_FUNCTIONS(X)
#undef X
  EglSurface surface = openSurface(egl);
  g_right = drawAndReport(load(getProc), "early");
  closeSurface(egl, surface);
}

} // namespace

extern "C" __attribute__((visibility("default"))) int earlyWasRight() { return g_right; }
