#include "gl_host.h"

#include <cmath>
#include <cstdio>
#include <dlfcn.h>
#include <utility>

namespace arbiter::differential {

namespace {
/// Returns an initialised display without a window system: on Mesa's surfaceless platform, the
/// default display, or a device.
EGLDisplay openDisplay() {
  const char *found = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const std::string extensions = found ? found : "";
  const auto has = [&](const char *name) { return extensions.find(name) != std::string::npos; };
  std::vector<EGLDisplay> candidates;
  if (has("EGL_MESA_platform_surfaceless"))
    candidates.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
  candidates.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
  if (has("EGL_EXT_platform_device") && has("EGL_EXT_device_enumeration")) {
    EGLDeviceEXT devices[8];
    EGLint count = 0;
    eglQueryDevicesEXT(8, devices, &count);
    for (EGLint i = 0; i < count; ++i)
      candidates.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
  }
  for (const EGLDisplay display : candidates)
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr))
      return display;
  return EGL_NO_DISPLAY;
}

GLuint colorTexture() {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kSide, kSide, 0, GL_RGBA, GL_FLOAT, nullptr);
  glBindTexture(GL_TEXTURE_2D, 0);
  return texture;
}
} // namespace

std::optional<GlHost> GlHost::create(std::string &why) {
  GlHost host;
  host.m_display = openDisplay();
  if (host.m_display == EGL_NO_DISPLAY) {
    why = "no EGL display could be initialised";
    return {};
  }
  eglBindAPI(EGL_OPENGL_API);
  const EGLint attributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                               EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(host.m_display, attributes, &config, 1, &count) || count == 0) {
    why = "no EGL configuration for desktop GL";
    return {};
  }
  host.m_context = eglCreateContext(host.m_display, config, EGL_NO_CONTEXT, nullptr);
  if (host.m_context == EGL_NO_CONTEXT) {
    why = "eglCreateContext failed";
    return {};
  }
  if (!eglMakeCurrent(host.m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, host.m_context)) {
    why = "eglMakeCurrent without a surface failed";
    return {};
  }
  return host;
}

GlHost::GlHost(GlHost &&other) noexcept
    : m_display(std::exchange(other.m_display, EGL_NO_DISPLAY)),
      m_context(std::exchange(other.m_context, EGL_NO_CONTEXT)) {}

GlHost::~GlHost() {
  if (m_context == EGL_NO_CONTEXT)
    return;
  eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(m_display, m_context);
  eglTerminate(m_display);
}

bool FloatTarget::create() {
  glGenFramebuffers(1, &m_framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
  for (int i = 0; i < kColorBuffers; ++i)
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + GLenum(i), GL_TEXTURE_2D,
                           colorTexture(), 0);
  GLuint depth = 0;
  glGenRenderbuffers(1, &depth);
  glBindRenderbuffer(GL_RENDERBUFFER, depth);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, kSide, kSide);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
  const GLenum buffers[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glDrawBuffers(kColorBuffers, buffers);
  glViewport(0, 0, kSide, kSide);
  glClampColorARB(GL_CLAMP_FRAGMENT_COLOR_ARB, GL_FALSE);
  glClampColorARB(GL_CLAMP_READ_COLOR_ARB, GL_FALSE);
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void FloatTarget::clear() const {
  glClearColor(kUntouched, kUntouched, kUntouched, kUntouched);
  glClearDepth(1.0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Pixels FloatTarget::read(int buffer) const {
  Pixels pixels;
  pixels.rgba.resize(std::size_t(kSide) * kSide * 4);
  pixels.depth.resize(std::size_t(kSide) * kSide);
  glReadBuffer(GL_COLOR_ATTACHMENT0 + GLenum(buffer));
  glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_FLOAT, pixels.rgba.data());
  glReadPixels(0, 0, kSide, kSide, GL_DEPTH_COMPONENT, GL_FLOAT, pixels.depth.data());
  return pixels;
}

namespace {
GLuint denormalProgram() {
  constexpr const char *kVertex = "uniform float small; varying float found;\n"
                                  "void main() { found = small * 1e30; gl_Position = gl_Vertex; }";
  constexpr const char *kFragment =
      "uniform float small; varying float found;\n"
      "void main() { gl_FragData[0] = vec4(found, small * 1e30, 0.0, 0.0); }";
  const GLuint program = glCreateProgram();
  for (const auto &[kind, text] :
       {std::pair(GL_VERTEX_SHADER, kVertex), std::pair(GL_FRAGMENT_SHADER, kFragment)}) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(program);
  return program;
}

bool drawsDenormals() {
  GLint framebuffer = 0, before = 0;
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer);
  glGetIntegerv(GL_CURRENT_PROGRAM, &before);
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  FloatTarget target;
  bool found = false;
  if (target.create()) {
    const GLuint program = denormalProgram();
    glUseProgram(program);
    glUniform1f(glGetUniformLocation(program, "small"), 1e-40f);
    glRectf(-1, -1, 1, 1);
    const Pixels pixels = target.read(0);
    found = pixels.rgba[0] != 0 || pixels.rgba[1] != 0;
    glUseProgram(GLuint(before));
    glDeleteProgram(program);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, GLuint(framebuffer));
  glPopAttrib();
  return found;
}
} // namespace

bool keepsDenormals() {
  static const bool s_keeps = drawsDenormals();
  return s_keeps;
}

float comparable(float value) {
  return std::fpclassify(value) == FP_SUBNORMAL && keepsDenormals() ? std::copysign(0.0f, value)
                                                                    : value;
}

bool layerInFront() { return dlsym(RTLD_DEFAULT, "__glx_Main") != nullptr; }

std::string takeErrors() {
  std::string text;
  for (int i = 0; i < 16; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR)
      break;
    char code[16];
    std::snprintf(code, sizeof code, "0x%04x ", error);
    text += code;
  }
  return text;
}

} // namespace arbiter::differential
