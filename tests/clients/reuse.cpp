/// Creates and destroys contexts until handles are reused. A new context must know nothing of the
/// previous one with its handle, and one destroyed while current must continue.
/// argv[1]: glx, egl or osmesa; argv[2]: cycles.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>
#include <vector>

#define GL_GLEXT_PROTOTYPES
#include "body.h"
#include "egl_surface.h"
#include "glx_window.h"

#include <GL/osmesa.h>
#include <dlfcn.h>

using namespace clients;

namespace {

struct Way {
  void *(*create)();
  bool (*makeCurrent)(void *context);
  void (*destroy)(void *context);
};

Glx g_glx;
GlxWindow g_window;
Egl g_egl;
EglSurface g_surface;
void *g_osmesa = nullptr;
std::vector<unsigned char> g_buffer(64 * 64 * 4);

void *library(const char *name) {
  void *const handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
  if (!handle)
    die("dlopen:", dlerror());
  return handle;
}

void *fromGl(const char *name) {
  static void *const s = library("libGL.so.1");
  return dlsym(s, name);
}
void *fromEgl(const char *name) {
  static void *const s = library("libEGL.so.1");
  return dlsym(s, name);
}
void *byGlx(const char *name) {
  return reinterpret_cast<void *>(g_glx.GetProcAddressARB(reinterpret_cast<const GLubyte *>(name)));
}
void *byEgl(const char *name) { return reinterpret_cast<void *>(g_egl.GetProcAddress(name)); }
void *byOsmesa(const char *name) { return dlsym(g_osmesa, name); }

template <typename Function> Function *osmesa(Function *, const char *name) {
  return reinterpret_cast<Function *>(dlsym(g_osmesa, name));
}
#define OSMESA(name) osmesa(&::name, #name)

Way prepareGlx(Gl &gl) {
  g_glx = loadGlx(fromGl);
  g_window = openWindow(g_glx, false);
  gl = load(byGlx);
  return {[]() -> void * {
            return g_glx.CreateContext(g_window.display, g_window.visual, nullptr, True);
          },
          [](void *context) -> bool {
            return g_glx.MakeCurrent(g_window.display, context ? g_window.window : None,
                                     static_cast<GLXContext>(context));
          },
          [](void *context) {
            g_glx.DestroyContext(g_window.display, static_cast<GLXContext>(context));
          }};
}

Way prepareEgl(Gl &gl) {
  g_egl = loadEgl(fromEgl);
  g_surface = openSurface(g_egl);
  g_egl.MakeCurrent(g_surface.display, nullptr, nullptr, nullptr);
  gl = load(byEgl);
  return {[]() -> void * {
            return g_egl.CreateContext(g_surface.display, g_surface.config, nullptr, nullptr);
          },
          [](void *context) -> bool {
            const EGLSurface surface = context ? g_surface.surface : EGL_NO_SURFACE;
            return g_egl.MakeCurrent(g_surface.display, surface, surface, context);
          },
          [](void *context) { g_egl.DestroyContext(g_surface.display, context); }};
}

Way prepareOsmesa(Gl &gl) {
  g_osmesa = library("libOSMesa.so.8");
  gl = load(byOsmesa);
  return {[]() -> void * { return OSMESA(OSMesaCreateContext)(OSMESA_RGBA, nullptr); },
          [](void *context) -> bool {
            return OSMESA(OSMesaMakeCurrent)(static_cast<OSMesaContext>(context), g_buffer.data(),
                                             GL_UNSIGNED_BYTE, 64, 64);
          },
          [](void *context) {
            OSMESA(OSMesaDestroyContext)
            (static_cast<OSMesaContext>(context));
          }};
}

/// True if a new context has nothing bound, nothing enabled and no parameter of the previous one.
bool isFresh(const Gl &gl) {
  GLint bound = -1;
  gl.GetProgramivARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_BINDING_ARB, &bound);
  return bound == 0 && !gl.IsEnabled(GL_FRAGMENT_PROGRAM_ARB) && gl.GetError() == GL_NO_ERROR;
}

void leaveTraces(const Gl &gl) {
  gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, 7);
  gl.Enable(GL_FRAGMENT_PROGRAM_ARB);
  gl.Enable(0xFFFF); // an error that nobody fetches
}

} // namespace

int main(int argc, char **argv) {
  const char *const kind = argc > 1 ? argv[1] : "glx";
  const int cycles = argc > 2 ? std::atoi(argv[2]) : 1000;
  Gl gl;
  const bool osmesa = !std::strcmp(kind, "osmesa");
  const Way way = osmesa                      ? prepareOsmesa(gl)
                  : !std::strcmp(kind, "egl") ? prepareEgl(gl)
                                              : prepareGlx(gl);
  std::set<void *> handles;
  int leftovers = 0;
  for (int i = 0; i < cycles; ++i) {
    void *const context = way.create();
    if (!context || !way.makeCurrent(context))
      die("no context");
    handles.insert(context);
    leftovers += !isFresh(gl);
    leaveTraces(gl);
    // Every other context is destroyed while current; OSMesa unbinds it.
    if (i % 2 == 0)
      way.makeCurrent(nullptr);
    way.destroy(context);
    if (i % 2 == 1 && !osmesa && !gl.IsEnabled(GL_FRAGMENT_PROGRAM_ARB))
      ++leftovers; // destroyed, but current, and so still in use
    if (i % 2 == 1)
      way.makeCurrent(nullptr);
  }
  void *const last = way.create();
  if (!last || !way.makeCurrent(last))
    die("no context");
  if (!osmesa)
    way.destroy(last);
  const bool right = drawAndReport(gl, kind);
  way.makeCurrent(nullptr);
  if (osmesa)
    way.destroy(last);
  std::fprintf(stderr, "%d cycles, %zu handles, %d stale\n", cycles, handles.size(), leftovers);
  return right && leftovers == 0 && int(handles.size()) < cycles ? 0 : 1;
}
