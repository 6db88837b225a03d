/// Tests NV_vertex_array_range's memory: glXAllocateMemoryNV and glXFreeMemoryNV by GetProcAddress,
/// with an open display and no context. The memory is written to, and another thread frees it.
/// Prints "absent" if there is none.
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <thread>

#include <dlfcn.h>

#include "body.h"
#include "glx_window.h"

using namespace clients;

namespace {

Glx g_glx;

void *fromGl(const char *name) {
  static void *const s_library = dlopen("libGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!s_library)
    die("dlopen:", dlerror());
  return dlsym(s_library, name);
}
void *byGlx(const char *name) {
  return reinterpret_cast<void *>(g_glx.GetProcAddressARB(reinterpret_cast<const GLubyte *>(name)));
}

} // namespace

int main() {
  g_glx = loadGlx(fromGl);
  GlxWindow window = openWindow(g_glx, false);
  const auto allocate =
      reinterpret_cast<void *(*)(GLsizei, GLfloat, GLfloat, GLfloat)>(byGlx("glXAllocateMemoryNV"));
  const auto release = reinterpret_cast<void (*)(void *)>(byGlx("glXFreeMemoryNV"));
  if (!allocate || !release) {
    std::puts("absent");
    return 0;
  }
  constexpr GLsizei kBytes = 3 << 20;
  void *const first = allocate(kBytes, 0, 1, 0.5f);
  void *const second = allocate(1, 0, 1, 0.5f);
  if (!first || !second || first == second || reinterpret_cast<std::uintptr_t>(first) % 32 != 0)
    die("no memory, or not aligned");
  std::memset(first, 1, kBytes);
  int local = 0;
  release(&local); // this was not allocated here, so that it is ignored
  release(nullptr);
  std::thread([&] { release(second); }).join();
  release(second); // a second time, so that it is ignored
  if (allocate(0, 0, 0, 0) || allocate(-5, 0, 0, 0))
    die("memory of no bytes");
  std::memset(first, 2, kBytes);
  release(first);
  std::puts("allocated");
  XCloseDisplay(window.display);
}
