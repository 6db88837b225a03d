#include "fixture.h"

#include <cstdio>
#include <cstdlib>

namespace api {

namespace {

EGLDisplay g_display = EGL_NO_DISPLAY;
EGLConfig g_config = nullptr;

bool openDisplay() {
  g_display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (g_display == EGL_NO_DISPLAY || !eglInitialize(g_display, nullptr, nullptr) ||
      !eglBindAPI(EGL_OPENGL_API))
    return false;
  const EGLint attributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                               EGL_OPENGL_BIT, EGL_NONE};
  EGLint count = 0;
  return eglChooseConfig(g_display, attributes, &g_config, 1, &count) && count == 1;
}

GLuint compile(GLenum type, const char *text) {
  const GLuint shader = glCreateShader(type);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  return shader;
}

} // namespace

GlContext::GlContext(const GlContext *share) {
  m_context =
      eglCreateContext(g_display, g_config, share ? share->m_context : EGL_NO_CONTEXT, nullptr);
  makeCurrent();
  glGenFramebuffers(1, &m_framebuffer);
  glGenRenderbuffers(1, &m_renderbuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
  glBindRenderbuffer(GL_RENDERBUFFER, m_renderbuffer);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 32, 32);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_renderbuffer);
  glViewport(0, 0, 32, 32);
}

GlContext::~GlContext() {
  if (eglGetCurrentContext() == m_context)
    eglMakeCurrent(g_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(g_display, m_context);
}

void GlContext::makeCurrent() const {
  eglMakeCurrent(g_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context);
}

bool layered() { return std::getenv("API_TEST_LAYERED") != nullptr; }

void load(const std::string &text, GLenum target) {
  glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()), text.data());
}

GLuint makeProgram(const std::string &text, GLenum target) {
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glBindProgramARB(target, name);
  load(text, target);
  return name;
}

GLint programiv(GLenum pname, GLenum target) {
  GLint value = -12345;
  glGetProgramivARB(target, pname, &value);
  return value;
}

GLint integer(GLenum pname) {
  GLint value = -12345;
  glGetIntegerv(pname, &value);
  return value;
}

void clear() {
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
}

void drawQuad() {
  glColor4f(0, 0, 1, 1);
  glBegin(GL_QUADS);
  glVertex2f(-1, -1);
  glVertex2f(1, -1);
  glVertex2f(1, 1);
  glVertex2f(-1, 1);
  glEnd();
}

Pixel readPixel(int x, int y) {
  std::array<GLubyte, 4> bytes = {1, 2, 3, 4};
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  return {bytes[0], bytes[1], bytes[2], bytes[3]};
}

Pixel drawn() {
  clear();
  drawQuad();
  return readPixel();
}

GLuint makeGlsl(const char *vertex, const char *fragment) {
  const GLuint program = glCreateProgram();
  if (vertex)
    glAttachShader(program, compile(GL_VERTEX_SHADER, vertex));
  if (fragment)
    glAttachShader(program, compile(GL_FRAGMENT_SHADER, fragment));
  glLinkProgram(program);
  return program;
}

} // namespace api

int main(int argc, char **argv) {
  ::testing::InitGoogleTest(&argc, argv);
  if (!api::openDisplay()) {
    std::fprintf(stderr, "no surfaceless EGL display here\n");
    return 77; // meson: skipped
  }
  return RUN_ALL_TESTS();
}
