#include "platform.h"

#include <cstdio>
#include <cstdlib>

#include <epoxy/egl.h>

namespace sharing {

void die(const char *what) {
  std::fprintf(stderr, "sharing: %s\n", what);
  std::exit(2);
}

namespace {

class EglPlatform final : public Platform {
public:
  EglPlatform() {
    m_display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (!eglInitialize(m_display, nullptr, nullptr))
      die("no EGL display");
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
                             EGL_ALPHA_SIZE,
                             8,
                             EGL_DEPTH_SIZE,
                             24,
                             EGL_STENCIL_SIZE,
                             8,
                             EGL_NONE};
    EGLint count = 0;
    if (!eglChooseConfig(m_display, wanted, &m_config, 1, &count) || count == 0)
      die("no EGL configuration of RGBA8 with depth and stencil");
  }

  void *makeContext(void *share) override {
    eglBindAPI(EGL_OPENGL_API); // for the calling thread
    const EGLContext context = eglCreateContext(m_display, m_config, share, nullptr);
    if (context == EGL_NO_CONTEXT)
      die("no EGL context");
    return context;
  }
  void destroyContext(void *context) override { eglDestroyContext(m_display, context); }
  void *makeDrawable(Size size) override {
    const EGLint attributes[] = {EGL_WIDTH, size.width, EGL_HEIGHT, size.height, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(m_display, m_config, attributes);
    if (surface == EGL_NO_SURFACE)
      die("no EGL pbuffer");
    return surface;
  }
  void destroyDrawable(void *drawable) override { eglDestroySurface(m_display, drawable); }
  void makeCurrent(void *drawable, void *context) override {
    eglBindAPI(EGL_OPENGL_API);
    if (!eglMakeCurrent(m_display, drawable, drawable, context))
      die("an EGL context does not become current");
  }

private:
  EGLDisplay m_display = EGL_NO_DISPLAY;
  EGLConfig m_config = nullptr;
};

} // namespace

std::unique_ptr<Platform> makeEglPlatform() { return std::make_unique<EglPlatform>(); }

} // namespace sharing
