#include "surface.h"

#include <X11/Xutil.h>

#include <cstdio>
#include <cstdlib>

namespace software {

bool Screen::open() {
  m_display = XOpenDisplay(nullptr);
  if (!m_display) {
    std::fprintf(stderr, "software: no X display\n");
    return false;
  }
  const int wanted[] = {GLX_DRAWABLE_TYPE,
                        GLX_PBUFFER_BIT | GLX_WINDOW_BIT,
                        GLX_RENDER_TYPE,
                        GLX_RGBA_BIT,
                        GLX_RED_SIZE,
                        8,
                        GLX_GREEN_SIZE,
                        8,
                        GLX_BLUE_SIZE,
                        8,
                        GLX_ALPHA_SIZE,
                        8,
                        GLX_DEPTH_SIZE,
                        24,
                        GLX_STENCIL_SIZE,
                        8,
                        GLX_DOUBLEBUFFER,
                        True,
                        None};
  int count = 0;
  GLXFBConfig *const configs =
      glXChooseFBConfig(m_display, DefaultScreen(m_display), wanted, &count);
  if (!configs || count == 0) {
    std::fprintf(stderr, "software: no GLX configuration of RGBA8 with depth and stencil\n");
    return false;
  }
  m_config = configs[0];
  XFree(configs);
  return true;
}

GLXDrawable Screen::makeWindow(int width, int height) {
  XVisualInfo *const visual = glXGetVisualFromFBConfig(m_display, m_config);
  const Window root = DefaultRootWindow(m_display);
  XSetWindowAttributes attributes = {};
  attributes.colormap = XCreateColormap(m_display, root, visual->visual, AllocNone);
  m_window =
      XCreateWindow(m_display, root, 0, 0, unsigned(width), unsigned(height), 0, visual->depth,
                    InputOutput, visual->visual, CWColormap | CWBorderPixel, &attributes);
  XMapWindow(m_display, m_window);
  XSync(m_display, False);
  XFree(visual);
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
  std::vector<unsigned char> bytes;
  XImage *const image =
      XGetImage(m_display, m_window, 0, 0, unsigned(width), unsigned(height), AllPlanes, ZPixmap);
  for (int y = height - 1; image && y >= 0; --y) {
    for (int x = 0; x < width; ++x) {
      const unsigned long pixel = XGetPixel(image, x, y);
      for (const int shift : {16, 8, 0})
        bytes.push_back(static_cast<unsigned char>(pixel >> shift));
      bytes.push_back(255);
    }
  }
  if (image)
    XDestroyImage(image);
  return bytes;
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

std::uint64_t Random::bits() {
  m_state += 0x9e3779b97f4a7c15u;
  std::uint64_t z = m_state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

} // namespace software
