/// Acts as libglvnd: loads the layer's and the host's vendor mains and compares their answers.
/// argv[1] the layer, argv[2] the host's EGL vendor.
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>

#include <dlfcn.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <glvnd/libeglabi.h>
#include <glvnd/libglxabi.h>

namespace {

int g_failures = 0;

void check(bool ok, const char *what, const char *name) {
  if (!ok) {
    std::fprintf(stderr, "vendor_gpa: %s: %s\n", name, what);
    ++g_failures;
  }
}

void *entry(const char *library, const char *name) {
  void *const handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
  return handle ? dlsym(handle, name) : nullptr;
}

bool inLayer(const void *function, const void *layerMain) {
  Dl_info a, b;
  return function && dladdr(function, &a) && dladdr(layerMain, &b) && a.dli_fbase == b.dli_fbase;
}

constexpr const char *kIntercepted[] = {"glProgramStringARB", "glBindProgramARB",
                                        "glBindProgramNV",    "glEnable",
                                        "glDrawArrays",       "glDrawArraysEXT",
                                        "glGetError",         "glUseProgramObjectARB",
                                        "glUseProgram",       "glCopyTexSubImage2D",
                                        "glUniform4fv",       "glUniform4fvARB",
                                        "glTexImage2D",       "glTexEnvi"};
/// These exist for the rasterizer: if the host is the backend, the host's own are returned.
constexpr const char *kForRasterizer[] = {"glClear", "glViewport",  "glVertex3f",
                                          "glFlush", "glBlendFunc", "glClearColor"};
constexpr const char *kPassed[] = {"glIsBuffer", "glIsTexture", "glGenTextures",
                                   "glNoSuchFunctionOfAnyGl"};

bool backendIsHost() {
  const char *const backend = std::getenv("ARBITER_BACKEND");
  return backend && std::strcmp(backend, "host") == 0;
}

/// Compares answers. `host` is the host's own GetProcAddress, or null if it cannot be called beside
/// the layer.
template <typename Layer>
void compare(Layer layer, void *(*host)(const char *), const void *main, const char *const *hooks,
             int hookCount) {
  for (const char *name : kIntercepted)
    check(inLayer(layer(name), main), "is not the layer's", name);
  for (int i = 0; i < hookCount; ++i)
    check(inLayer(layer(hooks[i]), main), "is not the layer's", hooks[i]);
  const auto checkPassed = [&](const char *name) {
    check(host ? layer(name) == host(name) : !inLayer(layer(name), main),
          "is not the host's own pointer", name);
  };
  for (const char *name : kPassed)
    checkPassed(name);
  for (const char *name : kForRasterizer)
    if (backendIsHost())
      checkPassed(name);
    else
      check(inLayer(layer(name), main), "is not the layer's", name);
}

__EGLapiImports g_eglLayer, g_eglHost;
__GLXapiImports g_glxLayer;

const GLubyte *bytes(const char *text) { return reinterpret_cast<const GLubyte *>(text); }

void compareEgl(const char *layerPath, const char *hostPath) {
  const __EGLapiExports exports = {};
  const auto layer = reinterpret_cast<__PFNEGLMAINPROC>(entry(layerPath, "__egl_Main"));
  const auto host = reinterpret_cast<__PFNEGLMAINPROC>(entry(hostPath, "__egl_Main"));
  // The host starts first: it then keeps what the layer passes in the second handshake.
  if (!layer || !host || !host(EGL_VENDOR_ABI_VERSION, &exports, nullptr, &g_eglHost) ||
      !layer(EGL_VENDOR_ABI_VERSION, &exports, nullptr, &g_eglLayer)) {
    check(false, "does not start", "EGL");
    return;
  }
  const char *const hooks[] = {"eglCreateContext", "eglDestroyContext", "eglMakeCurrent",
                               "eglSwapBuffers",   "eglTerminate",      "eglReleaseThread",
                               "eglGetProcAddress"};
  compare([](const char *n) { return g_eglLayer.getProcAddress(n); },
          [](const char *n) { return g_eglHost.getProcAddress(n); },
          reinterpret_cast<const void *>(layer), hooks, 7);
  const auto gpa =
      reinterpret_cast<void *(*)(const char *)>(g_eglLayer.getProcAddress("eglGetProcAddress"));
  check(gpa && gpa("eglGetProcAddress") == reinterpret_cast<void *>(gpa), "is not itself",
        "eglGetProcAddress");
  check(!g_eglLayer.isPatchSupported && !g_eglLayer.initiatePatch && !g_eglLayer.releasePatch,
        "patch callbacks are left in place", "EGL");
}

/// Compares GLX answers. Mesa's GLX vendor fills its imports for the first caller only, which is
/// the layer here.
void compareGlx(const char *layerPath) {
  const __GLXapiExports exports = {};
  const auto layer = reinterpret_cast<__PFNGLXMAINPROC>(entry(layerPath, "__glx_Main"));
  if (!layer || !layer(GLX_VENDOR_ABI_VERSION, &exports, nullptr, &g_glxLayer)) {
    check(false, "does not start", "GLX");
    return;
  }
  const char *const hooks[] = {
      "glXCreateContext",     "glXCreateNewContext",       "glXDestroyContext", "glXCopyContext",
      "glXMakeCurrent",       "glXMakeContextCurrent",     "glXSwapBuffers",    "glXGetProcAddress",
      "glXGetProcAddressARB", "glXCreateContextAttribsARB"};
  compare([](const char *n) { return g_glxLayer.getProcAddress(bytes(n)); }, nullptr,
          reinterpret_cast<const void *>(layer), hooks, 10);
  const auto gpa = reinterpret_cast<void *(*)(const GLubyte *)>(
      g_glxLayer.getProcAddress(bytes("glXGetProcAddressARB")));
  check(gpa && gpa(bytes("glXGetProcAddressARB")) == reinterpret_cast<void *>(gpa), "is not itself",
        "glXGetProcAddressARB");
  check(!g_glxLayer.isPatchSupported && !g_glxLayer.initiatePatch && !g_glxLayer.releasePatch,
        "patch callbacks are left in place", "GLX");
}

void checkOsmesa(const char *layerPath) {
  const auto gpa =
      reinterpret_cast<void *(*)(const char *)>(entry(layerPath, "OSMesaGetProcAddress"));
  check(gpa && gpa("OSMesaGetProcAddress") == reinterpret_cast<void *>(gpa), "is not itself",
        "OSMesaGetProcAddress");
  for (const char *name : kIntercepted)
    check(gpa && inLayer(gpa(name), reinterpret_cast<const void *>(gpa)), "is not the layer's",
          name);
  for (const char *name : {"glIsTexture", "glClear"})
    if (backendIsHost() || std::strcmp(name, "glIsTexture") == 0)
      check(gpa && gpa(name) && !inLayer(gpa(name), reinterpret_cast<const void *>(gpa)),
            "is the layer's", name);
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 3)
    return 3;
  compareEgl(argv[1], argv[2]);
  compareGlx(argv[1]);
  checkOsmesa(argv[1]);
  return g_failures != 0;
}
