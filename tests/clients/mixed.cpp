/// Uses three providers in one process, one after the other and back: GLX, OSMesa, EGL, GLX again.
#include <vector>

#include <dlfcn.h>

#include "body.h"
#include "egl_surface.h"
#include "glx_window.h"

#include <GL/osmesa.h>

using namespace clients;

namespace {

void *g_osmesa = nullptr;
Glx g_glx;
Egl g_egl;

void *fromGl(const char *name) {
  static void *const s_library = dlopen("libGL.so.1", RTLD_NOW | RTLD_LOCAL);
  return dlsym(s_library, name);
}
void *fromEgl(const char *name) {
  static void *const s_library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  return dlsym(s_library, name);
}
void *byGlx(const char *name) {
  return reinterpret_cast<void *>(g_glx.GetProcAddressARB(reinterpret_cast<const GLubyte *>(name)));
}
void *byEgl(const char *name) { return reinterpret_cast<void *>(g_egl.GetProcAddress(name)); }
void *byOsmesa(const char *name) { return dlsym(g_osmesa, name); }

} // namespace

int main() {
  g_glx = loadGlx(fromGl);
  GlxWindow window = openWindow(g_glx);
  bool right = drawAndReport(load(byGlx), "glx", 1.0f, true);
  g_glx.MakeCurrent(window.display, None, nullptr);

  g_osmesa = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (!g_osmesa)
    die("dlopen:", dlerror());
  const auto create =
      reinterpret_cast<decltype(&::OSMesaCreateContext)>(byOsmesa("OSMesaCreateContext"));
  const auto makeCurrent =
      reinterpret_cast<decltype(&::OSMesaMakeCurrent)>(byOsmesa("OSMesaMakeCurrent"));
  std::vector<unsigned char> buffer(64 * 64 * 4);
  const OSMesaContext context = create(OSMESA_RGBA, nullptr);
  if (!context || !makeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 64, 64))
    die("no OSMesa context");
  right &= drawAndReport(load(byOsmesa), "osmesa", 0.5f, true);
  makeCurrent(nullptr, nullptr, 0, 0, 0);

  g_egl = loadEgl(fromEgl);
  EglSurface surface = openSurface(g_egl);
  right &= drawAndReport(load(byEgl), "egl", 0.75f, true);
  closeSurface(g_egl, surface);

  if (!g_glx.MakeCurrent(window.display, window.window, window.context))
    die("GLX again");
  right &= drawAndReport(load(byGlx), "glx, osmesa, egl, glx", 0.25f);
  closeWindow(g_glx, window);
  return right ? 0 : 1;
}
