#include "apps/tools/draw/surface.h"

namespace arbiter::tools {

namespace {

EGLDisplay initialised(EGLenum platform, void *native) {
  const EGLDisplay display = eglGetPlatformDisplayEXT(platform, native, nullptr);
  return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) ? display
                                                                               : EGL_NO_DISPLAY;
}

/// Returns Mesa's surfaceless platform, or the first usable device (NVIDIA).
EGLDisplay findDisplay() {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base"))
    return EGL_NO_DISPLAY;
  EGLDisplay display = EGL_NO_DISPLAY;
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
    display = initialised(EGL_PLATFORM_SURFACELESS_MESA, nullptr);
  if (display != EGL_NO_DISPLAY ||
      !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device"))
    return display;
  EGLDeviceEXT devices[16];
  EGLint count = 0;
  if (!eglQueryDevicesEXT(16, devices, &count))
    return EGL_NO_DISPLAY;
  for (EGLint i = 0; i < count && display == EGL_NO_DISPLAY; ++i)
    display = initialised(EGL_PLATFORM_DEVICE_EXT, devices[i]);
  return display;
}

} // namespace

Surface::~Surface() {
  if (m_display == EGL_NO_DISPLAY)
    return;
  eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglTerminate(m_display);
}

const char *Surface::open(int width, int height) {
  m_display = findDisplay();
  if (m_display == EGL_NO_DISPLAY)
    return "no EGL display without a window system";
  static constexpr EGLint kConfig[] = {EGL_SURFACE_TYPE,
                                       EGL_PBUFFER_BIT,
                                       EGL_RENDERABLE_TYPE,
                                       EGL_OPENGL_BIT,
                                       EGL_RED_SIZE,
                                       8,
                                       EGL_GREEN_SIZE,
                                       8,
                                       EGL_BLUE_SIZE,
                                       8,
                                       EGL_ALPHA_SIZE,
                                       8,
                                       EGL_DEPTH_SIZE,
                                       24,
                                       EGL_STENCIL_SIZE,
                                       8,
                                       EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(m_display, kConfig, &config, 1, &count) ||
      count == 0)
    return "no EGL configuration with desktop GL and a pbuffer";
  const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
  const EGLSurface surface = eglCreatePbufferSurface(m_display, config, size);
  const EGLContext context = eglCreateContext(m_display, config, EGL_NO_CONTEXT, nullptr);
  if (surface == EGL_NO_SURFACE || context == EGL_NO_CONTEXT)
    return "no pbuffer of this size, or no GL context";
  return eglMakeCurrent(m_display, surface, surface, context) ? nullptr : "eglMakeCurrent failed";
}

} // namespace arbiter::tools
