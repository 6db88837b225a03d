/// Finds EGL by dlopen and dlsym, and GL by eglGetProcAddress.
#include <dlfcn.h>

#include "body.h"
#include "egl_surface.h"

using namespace clients;

namespace {

void *g_library = nullptr;
Egl g_egl;

void *getEgl(const char *name) { return dlsym(g_library, name); }
void *getGl(const char *name) { return reinterpret_cast<void *>(g_egl.GetProcAddress(name)); }

} // namespace

int main() {
  g_library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!g_library)
    die("dlopen:", dlerror());
  g_egl = loadEgl(getEgl);
  EglSurface surface = openSurface(g_egl);
  const bool right = drawAndReport(load(getGl), "egl_dynamic");
  closeSurface(g_egl, surface);
  return right ? 0 : 1;
}
