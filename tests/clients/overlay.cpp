/// A preloaded overlay like MangoHud and VirtualGL: it exports the GLX calls that it intercepts,
/// and finds the next ones by dlsym. Prints at exit what it intercepted.
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <cstdio>
#include <cstring>

#include <dlfcn.h>

#include <GL/glx.h>

#define OVERLAY extern "C" __attribute__((visibility("default")))

namespace {

int g_swaps = 0;

void *next(const char *name) {
  void *found = dlsym(RTLD_NEXT, name);
  if (!found)
    if (void *const library = dlopen("libGL.so.1", RTLD_LAZY))
      found = dlsym(library, name);
  return found;
}

[[gnu::destructor]] void report() { std::fprintf(stderr, "overlay: %d swaps\n", g_swaps); }

} // namespace

OVERLAY void glXSwapBuffers(Display *display, GLXDrawable drawable) {
  ++g_swaps;
  // An overlay draws with GL functions that it finds itself.
  const auto getString = reinterpret_cast<decltype(&::glGetString)>(next("glGetString"));
  if (!getString(GL_VERSION))
    std::fprintf(stderr, "overlay: no GL version\n");
  reinterpret_cast<decltype(&::glXSwapBuffers)>(next("glXSwapBuffers"))(display, drawable);
}

OVERLAY __GLXextFuncPtr glXGetProcAddressARB(const GLubyte *name) {
  if (!std::strcmp(reinterpret_cast<const char *>(name), "glXSwapBuffers"))
    return reinterpret_cast<__GLXextFuncPtr>(&glXSwapBuffers);
  return reinterpret_cast<decltype(&::glXGetProcAddressARB)>(next("glXGetProcAddressARB"))(name);
}
