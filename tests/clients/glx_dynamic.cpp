/// Finds GL at run time. argv[1] says how:
///   libGL, libOpenGL  dlopen of the name, dlsym
///   absolute PATH     dlopen of a path
///   default           libGL loaded RTLD_GLOBAL, dlsym(RTLD_DEFAULT)
///   dlvsym            as libGL, but the first function by dlvsym of a version that has none
///   libdl             dlsym itself taken from libdl.so.2
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <cstring>

#include <dlfcn.h>

#include "body.h"
#include "glx_window.h"

using namespace clients;

namespace {

/// The symbol version of the C library's oldest functions on this processor.
#if defined(__i386__)
constexpr const char *kFirstVersion = "GLIBC_2.0";
#else
constexpr const char *kFirstVersion = "GLIBC_2.2.5";
#endif

void *g_gl = nullptr;
void *g_glx = nullptr;
decltype(Glx::GetProcAddressARB) g_getProc = nullptr;
void *(*g_dlsym)(void *, const char *) = nullptr;

void *open(const char *name, int flags = RTLD_NOW | RTLD_LOCAL) {
  void *const handle = dlopen(name, flags);
  if (!handle)
    die("dlopen:", dlerror());
  return handle;
}

void *getGlx(const char *name) { return g_dlsym(g_glx, name); }

void *getGl(const char *name) {
  void *const found = g_dlsym(g_gl, name);
  return found ? found
               : reinterpret_cast<void *>(g_getProc(reinterpret_cast<const GLubyte *>(name)));
}

void *systemDlsym(void *handle, const char *name) { return dlsym(handle, name); }

/// Looks up a function with a version. libc and libGLX have versions; libGL's symbols have none,
/// and dlvsym must fail cleanly.
void *versionedDlsym(void *handle, const char *name) {
  void *const found = dlvsym(handle, name, kFirstVersion);
  return found ? found : dlsym(handle, name);
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 2)
    die("which way?");
  const char *const way = argv[1];
  g_dlsym = systemDlsym;
  if (!std::strcmp(way, "libOpenGL")) {
    g_gl = open("libOpenGL.so.0");
    g_glx = open("libGLX.so.0");
  } else if (!std::strcmp(way, "absolute")) {
    g_gl = g_glx = open(argc > 2 ? argv[2] : "");
  } else if (!std::strcmp(way, "default")) {
    open("libGL.so.1", RTLD_NOW | RTLD_GLOBAL);
    g_gl = g_glx = RTLD_DEFAULT;
  } else {
    g_gl = g_glx = open("libGL.so.1");
    if (!std::strcmp(way, "dlvsym"))
      g_dlsym = versionedDlsym;
    if (!std::strcmp(way, "libdl"))
      g_dlsym =
          reinterpret_cast<decltype(g_dlsym)>(dlvsym(open("libdl.so.2"), "dlsym", kFirstVersion));
    if (!g_dlsym)
      die("libdl has no dlsym");
  }
  const Glx glx = loadGlx(getGlx);
  g_getProc = glx.GetProcAddressARB;
  GlxWindow window = openWindow(glx);
  const bool right = drawAndReport(load(getGl), way);
  closeWindow(glx, window);
  return right ? 0 : 1;
}
