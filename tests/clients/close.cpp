/// Closes or terminates a display with two contexts left, one of them current. It does so twice, so
/// that handles and display pointers are reused. argv[1]: glx or egl.
#include <cstring>

#include <dlfcn.h>

#include "body.h"
#include "egl_surface.h"
#include "glx_window.h"

using namespace clients;

namespace {

Glx g_glx;
Egl g_egl;

void *open(const char *name) {
  void *const handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
  if (!handle)
    die("dlopen:", dlerror());
  return handle;
}
void *fromGl(const char *name) {
  static void *const s_library = open("libGL.so.1");
  return dlsym(s_library, name);
}
void *fromEgl(const char *name) {
  static void *const s_library = open("libEGL.so.1");
  return dlsym(s_library, name);
}
void *byGlx(const char *name) {
  return reinterpret_cast<void *>(g_glx.GetProcAddressARB(reinterpret_cast<const GLubyte *>(name)));
}
void *byEgl(const char *name) { return reinterpret_cast<void *>(g_egl.GetProcAddress(name)); }

bool closeGlx(bool last) {
  GlxWindow window = openWindow(g_glx);
  if (!g_glx.CreateContext(window.display, window.visual, nullptr, True))
    die("no second context");
  const bool right = drawAndReport(load(byGlx), "glx", 1.0f, !last);
  g_glx.MakeCurrent(window.display, None, nullptr);
  XCloseDisplay(window.display);
  return right;
}

bool closeEgl(bool last) {
  EglSurface surface = openSurface(g_egl);
  if (!g_egl.CreateContext(surface.display, surface.config, nullptr, nullptr))
    die("no second context");
  const bool right = drawAndReport(load(byEgl), "egl", 1.0f, !last);
  g_egl.Terminate(surface.display);
  g_egl.ReleaseThread();
  return right;
}

} // namespace

int main(int argc, char **argv) {
  const bool egl = argc > 1 && !std::strcmp(argv[1], "egl");
  bool right = true;
  if (egl)
    g_egl = loadEgl(fromEgl);
  else
    g_glx = loadGlx(fromGl);
  for (int i = 0; i < 2; ++i)
    right &= egl ? closeEgl(i == 1) : closeGlx(i == 1);
  return right ? 0 : 1;
}
