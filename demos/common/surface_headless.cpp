#include "common/surface.h"

#include <cstdio>
#include <cstring>
#include <epoxy/egl.h>
#include <vector>

namespace demos {

Image Surface::readPixels() const {
  Image image(m_width, m_height);
  glReadBuffer(colorBuffer());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, m_width, m_height, GL_RGBA, GL_UNSIGNED_BYTE, image.bytes.data());
  return image;
}

namespace {

bool contains(const char *extensions, const char *name) {
  return extensions && std::strstr(extensions, name);
}

/// Returns the displays to try, best first.
std::vector<EGLDisplay> candidates() {
  const char *client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::vector<EGLDisplay> gpus, software;
  if (contains(client, "EGL_EXT_device_enumeration") &&
      contains(client, "EGL_EXT_platform_device")) {
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    if (eglQueryDevicesEXT(16, devices, &count)) {
      for (EGLint i = 0; i < count; ++i) {
        const char *traits = eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS);
        const EGLDisplay display =
            eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
        (contains(traits, "EGL_MESA_device_software") ? software : gpus).push_back(display);
      }
    }
  }
  if (contains(client, "EGL_MESA_platform_surfaceless"))
    gpus.push_back(
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  gpus.insert(gpus.end(), software.begin(), software.end());
  return gpus;
}

class HeadlessSurface final : public Surface {
public:
  ~HeadlessSurface() override;
  [[nodiscard]] bool open(int width, int height, bool pbuffer);
  [[nodiscard]] GLenum colorBuffer() const override {
    return m_framebuffer ? GL_COLOR_ATTACHMENT0 : GL_BACK;
  }
  void present() override { glFlush(); }

private:
  [[nodiscard]] bool openOn(EGLDisplay display, bool pbuffer);
  void makeFramebuffer();

  EGLDisplay m_display = EGL_NO_DISPLAY;
  EGLContext m_context = EGL_NO_CONTEXT;
  EGLSurface m_surface = EGL_NO_SURFACE;
  GLuint m_framebuffer = 0;
  GLuint m_renderbuffers[2] = {0, 0};
};

bool HeadlessSurface::openOn(EGLDisplay display, bool pbuffer) {
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
    return false;
  const EGLint want[] = {EGL_SURFACE_TYPE,
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
                         EGL_NONE};
  EGLConfig configs[64];
  EGLint count = 0;
  if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display, want, configs, 64, &count))
    return false;
  for (EGLint i = 0; i < count && m_context == EGL_NO_CONTEXT; ++i) {
    // EGL lists configurations with more bits first, but the comparisons need exactly 8 for each
    // color.
    EGLint red = 0;
    eglGetConfigAttrib(display, configs[i], EGL_RED_SIZE, &red);
    if (red != 8)
      continue;
    const EGLint size[] = {EGL_WIDTH, m_width, EGL_HEIGHT, m_height, EGL_NONE};
    m_surface = pbuffer ? eglCreatePbufferSurface(display, configs[i], size) : EGL_NO_SURFACE;
    if (!pbuffer || m_surface != EGL_NO_SURFACE)
      m_context = eglCreateContext(display, configs[i], EGL_NO_CONTEXT, nullptr);
  }
  m_display = display;
  if (m_context != EGL_NO_CONTEXT && eglMakeCurrent(display, m_surface, m_surface, m_context))
    return true;
  // The display stays initialised, as others in this process may use it.
  if (m_context != EGL_NO_CONTEXT)
    eglDestroyContext(display, m_context);
  if (m_surface != EGL_NO_SURFACE)
    eglDestroySurface(display, m_surface);
  m_context = EGL_NO_CONTEXT;
  m_surface = EGL_NO_SURFACE;
  return false;
}

bool HeadlessSurface::open(int width, int height, bool pbuffer) {
  m_width = width;
  m_height = height;
  for (EGLDisplay display : candidates()) {
    if (openOn(display, pbuffer)) {
      if (!pbuffer)
        makeFramebuffer();
      return true;
    }
  }
  std::fprintf(stderr, "no OpenGL context without a display: EGL offers neither a device nor the "
                       "surfaceless platform with OpenGL\n");
  return false;
}

void HeadlessSurface::makeFramebuffer() {
  glGenRenderbuffers(2, m_renderbuffers);
  glBindRenderbuffer(GL_RENDERBUFFER, m_renderbuffers[0]);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, m_width, m_height);
  glBindRenderbuffer(GL_RENDERBUFFER, m_renderbuffers[1]);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, m_width, m_height);
  glGenFramebuffers(1, &m_framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                            m_renderbuffers[0]);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                            m_renderbuffers[1]);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    std::fprintf(stderr, "the framebuffer object is not complete\n");
}

HeadlessSurface::~HeadlessSurface() {
  if (m_context == EGL_NO_CONTEXT)
    return;
  if (m_framebuffer) {
    glDeleteFramebuffers(1, &m_framebuffer);
    glDeleteRenderbuffers(2, m_renderbuffers);
  }
  eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(m_display, m_context);
  if (m_surface != EGL_NO_SURFACE)
    eglDestroySurface(m_display, m_surface);
  eglTerminate(m_display);
}

} // namespace

std::unique_ptr<Surface> makeHeadless(int width, int height, bool pbuffer) {
  auto surface = std::make_unique<HeadlessSurface>();
  if (!surface->open(width, height, pbuffer))
    return nullptr;
  return surface;
}

} // namespace demos
