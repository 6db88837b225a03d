/// An EGL vendor between the layer and the host that counts glClear and glDrawArrays. Each call of
/// the application must arrive exactly once, even if the host patches libglvnd's stubs.
/// COUNTING_HOST names the host's vendor library, COUNTING_FILE the file for the counts.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>

#include <glvnd/libeglabi.h>

namespace {

__EGLapiImports g_host;
unsigned long g_clears = 0;
unsigned long g_draws = 0;
decltype(&::glClear) g_clear = nullptr;
decltype(&::glDrawArrays) g_drawArrays = nullptr;

void countedClear(GLbitfield mask) {
  ++g_clears;
  g_clear(mask);
}

void countedDrawArrays(GLenum mode, GLint first, GLsizei count) {
  ++g_draws;
  g_drawArrays(mode, first, count);
}

void *getProcAddress(const char *name) {
  void *const host = g_host.getProcAddress(name);
  if (!std::strcmp(name, "glClear")) {
    g_clear = reinterpret_cast<decltype(g_clear)>(host);
    return reinterpret_cast<void *>(&countedClear);
  }
  if (!std::strcmp(name, "glDrawArrays")) {
    g_drawArrays = reinterpret_cast<decltype(g_drawArrays)>(host);
    return reinterpret_cast<void *>(&countedDrawArrays);
  }
  return host;
}

[[gnu::destructor]] void report() {
  const char *const path = std::getenv("COUNTING_FILE");
  FILE *const file = path && g_clear ? std::fopen(path, "w") : nullptr;
  if (!file)
    return;
  std::fprintf(file, "{\"clears\": %lu, \"draws\": %lu}\n", g_clears, g_draws);
  std::fclose(file);
}

} // namespace

extern "C" __attribute__((visibility("default"))) EGLBoolean
__egl_Main(uint32_t version, const __EGLapiExports *exports, __EGLvendorInfo *vendor,
           __EGLapiImports *imports) {
  const char *const name = std::getenv("COUNTING_HOST");
  void *const library = dlopen(name ? name : "libEGL_mesa.so.0", RTLD_LAZY | RTLD_LOCAL);
  const auto main =
      library ? reinterpret_cast<__PFNEGLMAINPROC>(dlsym(library, __EGL_MAIN_PROTO_NAME)) : nullptr;
  if (!main || !main(version, exports, vendor, &g_host))
    return EGL_FALSE;
  // All other imports are the host's, including its patch callbacks, which the layer must suppress.
  *imports = g_host;
  imports->getProcAddress = getProcAddress;
  return EGL_TRUE;
}
