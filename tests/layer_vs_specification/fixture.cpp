#include "fixture.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace api {

namespace {

EGLDisplay g_display = EGL_NO_DISPLAY;
EGLConfig g_config = nullptr;

bool opens(EGLDisplay display) {
  g_display = display;
  return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) &&
         eglBindAPI(EGL_OPENGL_API);
}

/// Opens Mesa's display without a window system, else a device's.
bool openDisplay() {
  if (opens(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)))
    return true;
  EGLDeviceEXT device = nullptr;
  EGLint count = 0;
  return epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
         eglQueryDevicesEXT(1, &device, &count) && count == 1 &&
         opens(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
}

bool chooseConfig() {
  const EGLint attributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                               EGL_OPENGL_BIT, EGL_NONE};
  EGLint count = 0;
  return openDisplay() && eglChooseConfig(g_display, attributes, &g_config, 1, &count) &&
         count == 1;
}

} // namespace

GlContext::GlContext(const GlContext *share, Profile profile) {
  const EGLint core[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
  m_context = eglCreateContext(g_display, g_config, share ? share->m_context : EGL_NO_CONTEXT,
                               profile == Profile::Core ? core : nullptr);
  makeCurrent();
  glGenFramebuffers(1, &m_framebuffer);
  glGenRenderbuffers(1, &m_renderbuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
  glBindRenderbuffer(GL_RENDERBUFFER, m_renderbuffer);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kSize, kSize);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_renderbuffer);
  glViewport(0, 0, kSize, kSize);
}

GlContext::~GlContext() {
  if (eglGetCurrentContext() == m_context)
    eglMakeCurrent(g_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(g_display, m_context);
}

void GlContext::makeCurrent() const {
  eglMakeCurrent(g_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context);
}

int mesaRelease() {
  const auto *const version = reinterpret_cast<const char *>(glGetString(GL_VERSION));
  const char *const mesa = version ? std::strstr(version, "Mesa ") : nullptr;
  return mesa ? std::atoi(mesa + std::strlen("Mesa ")) : 0;
}

bool layered() { return std::getenv("API_TEST_LAYERED") != nullptr; }

bool rasterizerDrawsAll() {
  const char *const backend = std::getenv("ARBITER_BACKEND");
  return layered() && backend && std::strcmp(backend, "swrast") == 0;
}

} // namespace api

int main(int argc, char **argv) {
  ::testing::InitGoogleTest(&argc, argv);
  if (!api::chooseConfig()) {
    std::fprintf(stderr, "skipped: no context without a window\n");
    return 77; // meson's code for skipped
  }
  return RUN_ALL_TESTS();
}
