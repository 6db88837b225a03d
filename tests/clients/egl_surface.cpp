#include "egl_surface.h"

#include <cstdlib>
#include <cstring>

#include "body.h"

namespace clients {

Egl loadEgl(void *(*get)(const char *name)) {
  Egl egl;
#define X(name)                                                                                    \
  egl.name = reinterpret_cast<decltype(egl.name)>(get("egl" #name));                               \
  if (!egl.name)                                                                                   \
    die("no function", "egl" #name);
  CLIENT_EGL_FUNCTIONS(X)
#undef X
  return egl;
}

namespace {

/// Reads CLIENT_EGL_PLATFORM, for machines without a display: "device" or "surfaceless".
EGLenum platformOfEnvironment() {
  const char *const name = std::getenv("CLIENT_EGL_PLATFORM");
  if (name && !std::strcmp(name, "device"))
    return EGL_PLATFORM_DEVICE_EXT;
  return name && !std::strcmp(name, "surfaceless") ? EGL_PLATFORM_SURFACELESS_MESA : 0;
}

EGLDisplay getDisplay(const Egl &egl, EGLenum platform) {
  if (!platform)
    platform = platformOfEnvironment();
  if (!platform)
    return egl.GetDisplay(EGL_DEFAULT_DISPLAY);
  const auto get = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      egl.GetProcAddress("eglGetPlatformDisplayEXT"));
  if (!get)
    die("no eglGetPlatformDisplayEXT");
  void *native = nullptr;
  if (platform == EGL_PLATFORM_DEVICE_EXT) {
    const auto query =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.GetProcAddress("eglQueryDevicesEXT"));
    EGLint count = 0;
    EGLDeviceEXT device = nullptr;
    if (!query || !query(1, &device, &count) || count < 1)
      die("no device");
    native = device;
  }
  return get(platform, native, nullptr);
}

} // namespace

EglSurface openSurface(const Egl &egl, EGLenum platform) {
  EglSurface s;
  s.display = getDisplay(egl, platform);
  EGLint count = 0;
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_GREEN_SIZE,
                           8,
                           EGL_BLUE_SIZE,
                           8,
                           EGL_NONE};
  if (s.display == EGL_NO_DISPLAY || !egl.Initialize(s.display, nullptr, nullptr))
    die("no EGL display");
  if (!egl.BindAPI(EGL_OPENGL_API) || !egl.ChooseConfig(s.display, wanted, &s.config, 1, &count) ||
      count < 1)
    die("no EGL config");
  const EGLint size[] = {EGL_WIDTH, 64, EGL_HEIGHT, 64, EGL_NONE};
  s.surface = egl.CreatePbufferSurface(s.display, s.config, size);
  s.context = egl.CreateContext(s.display, s.config, EGL_NO_CONTEXT, nullptr);
  if (s.surface == EGL_NO_SURFACE || s.context == EGL_NO_CONTEXT ||
      !egl.MakeCurrent(s.display, s.surface, s.surface, s.context))
    die("no EGL context");
  return s;
}

void closeSurface(const Egl &egl, EglSurface &s) {
  egl.MakeCurrent(s.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (s.context != EGL_NO_CONTEXT)
    egl.DestroyContext(s.display, s.context);
  egl.DestroySurface(s.display, s.surface);
  egl.Terminate(s.display);
  s = {};
}

} // namespace clients
