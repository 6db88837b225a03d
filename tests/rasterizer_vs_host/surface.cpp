#include "surface.h"

#include <cstdio>
#include <cstdlib>

#include "glx_windows.h"

namespace software {

bool Screen::open() {
  m_display = XOpenDisplay(nullptr);
  if (!m_display) {
    std::fprintf(stderr, "software: no X display\n");
    return false;
  }
  m_config = chooseGlxConfig(m_display, GLX_PBUFFER_BIT | GLX_WINDOW_BIT);
  if (!m_config) {
    std::fprintf(stderr, "software: no GLX configuration of RGBA8 with depth and stencil\n");
    return false;
  }
  return true;
}

GLXDrawable Screen::makeWindow(int width, int height) {
  m_window = software::makeWindow(m_display, m_config, width, height);
  return glXCreateWindow(m_display, m_config, m_window, nullptr);
}

GLXDrawable Screen::makePbuffer(int width, int height) {
  const int size[] = {GLX_PBUFFER_WIDTH, width, GLX_PBUFFER_HEIGHT, height, None};
  return glXCreatePbuffer(m_display, m_config, size);
}

GLXContext Screen::makeContext(GLXContext share) {
  const GLXContext context = glXCreateNewContext(m_display, m_config, GLX_RGBA_TYPE, share, True);
  if (!context) {
    std::fprintf(stderr, "software: no context\n");
    std::exit(2);
  }
  return context;
}

void Screen::makeCurrent(GLXDrawable drawable, GLXContext context) {
  if (!glXMakeContextCurrent(m_display, drawable, drawable, context)) {
    std::fprintf(stderr, "software: the context does not become current\n");
    std::exit(2);
  }
}

void Screen::destroy(GLXContext context) {
  glXMakeContextCurrent(m_display, None, None, nullptr);
  glXDestroyContext(m_display, context);
}

void Screen::swap(GLXDrawable drawable) { glXSwapBuffers(m_display, drawable); }

std::vector<unsigned char> Screen::grab(int width, int height) {
  glXWaitGL();
  XSync(m_display, False);
  return grabWindow(m_display, m_window, width, height);
}

void record(const std::string &text, const std::vector<unsigned char> &bytes) {
  std::printf("%s\t%zu\n", text.c_str(), bytes.size());
  if (!bytes.empty())
    std::fwrite(bytes.data(), 1, bytes.size(), stdout);
}

std::vector<unsigned char> readRgba(int x, int y, int width, int height) {
  std::vector<unsigned char> bytes(std::size_t(width) * std::size_t(height) * 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(x, y, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  return bytes;
}

std::string takeErrors() {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR)
      break;
    char code[16];
    std::snprintf(code, sizeof code, " 0x%04x", error);
    text += code;
  }
  return text;
}

GLuint makeProgram(GLenum target, const std::string &text) {
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glBindProgramARB(target, name);
  glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()), text.data());
  GLint position = -1;
  glGetIntegerv(GL_PROGRAM_ERROR_POSITION_ARB, &position);
  if (position != -1) {
    std::fprintf(stderr, "software: a program is rejected at %d: %s\n%s", position,
                 reinterpret_cast<const char *>(glGetString(GL_PROGRAM_ERROR_STRING_ARB)),
                 text.c_str());
    std::exit(2);
  }
  return name;
}

GLuint makeFramebuffer(GLuint texture) {
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  if (texture != 0)
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  return framebuffer;
}

GLuint attachBuffer(GLenum attachment, GLenum format, int width, int height) {
  GLuint buffer = 0;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
  return buffer;
}

std::uint64_t Random::bits() {
  m_state += 0x9e3779b97f4a7c15u;
  std::uint64_t z = m_state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

} // namespace software
