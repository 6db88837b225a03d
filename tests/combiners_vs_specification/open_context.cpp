#include "open_context.h"

#include <cstdio>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

bool openContext() {
  EGLDisplay display =
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") ||
        !eglQueryDevicesEXT(1, &device, &count) || count != 1)
      return false;
    display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    if (!eglInitialize(display, nullptr, nullptr))
      return false;
  }
  const EGLint attributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                               EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint configs = 0;
  if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display, attributes, &config, 1, &configs) ||
      configs != 1)
    return false;
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  return context != EGL_NO_CONTEXT &&
         eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

bool openContextWith(const char *extension) {
  if (!openContext()) {
    std::fprintf(stderr, "no OpenGL context without a window system\n");
    return false;
  }
  if (epoxy_has_gl_extension(extension))
    return true;
  std::fprintf(stderr, "%s is not announced\n", extension);
  return false;
}

void bindTarget(int width, int height, GLenum format) {
  GLuint framebuffer = 0, buffers[2] = {};
  glGenFramebuffers(1, &framebuffer);
  glGenRenderbuffers(2, buffers);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const GLenum formats[] = {format, GL_DEPTH_COMPONENT24};
  constexpr GLenum kPoints[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  for (int i = 0; i < 2; ++i) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
    glRenderbufferStorage(GL_RENDERBUFFER, formats[i], width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, kPoints[i], GL_RENDERBUFFER, buffers[i]);
  }
  glViewport(0, 0, width, height);
  glDisable(GL_DITHER);
}
