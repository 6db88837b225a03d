// A client without a window that draws one pixel again and again and prints its colour as "R G B"
// whenever it changed. It never swaps buffers, sets a local parameter around each draw, asks for
// its program string and counts, loads its program anew now and then, and one that is refused.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <unistd.h>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace {

const char kProgram[] = "!!ARBfp1.0\n"
                        "# caf\xe9: a Latin-1 byte\n"
                        "ADD result.color, program.local[0].yyyy, {0, 1, 0, 1};\n"
                        "END\n";
const char kRefused[] = "!!ARBfp1.0\n"
                        "# \xe9\n"
                        "MOV result.color, missing;\n"
                        "END\n";

bool makeContext() {
  const auto getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const EGLDisplay display = getDisplay(EGL_PLATFORM_SURFACELESS_MESA,
                                        reinterpret_cast<void *>(EGL_DEFAULT_DISPLAY), nullptr);
  if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
    return false;
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0)
    return false;
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  return context && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

void makeTarget() {
  GLuint texture = 0, framebuffer = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  glViewport(0, 0, 1, 1);
}

/// What the application was told after the load, and must always be told.
bool sameAsLoaded() {
  GLint length = 0, instructions = 0;
  glGetProgramivARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_LENGTH_ARB, &length);
  glGetProgramivARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_INSTRUCTIONS_ARB, &instructions);
  std::string text(std::size_t(length), '\0');
  glGetProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_STRING_ARB, text.data());
  return text == kProgram && instructions == 1 && glGetError() == GL_NO_ERROR;
}

} // namespace

int main(int argc, char **argv) {
  long frames = -1;
  if (argc == 3 && std::strcmp(argv[1], "--frames") == 0)
    frames = std::atol(argv[2]);
  if (!makeContext()) {
    std::puts("no context");
    return 1;
  }
  makeTarget();
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, 2);
  glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, sizeof kRefused - 1,
                     kRefused);
  if (glGetError() == GL_NO_ERROR)
    std::puts("accepted");
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, 1);
  glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, sizeof kProgram - 1,
                     kProgram);
  std::array<unsigned char, 4> last{1, 2, 3, 4};
  for (long frame = 0; frame != frames; ++frame) {
    if (frame % 20 == 10) { // a new object with the same text
      const GLuint name = 1;
      glDeleteProgramsARB(1, &name);
      glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, name);
      glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, sizeof kProgram - 1,
                         kProgram);
    }
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, GLfloat(frame), 0, 0, 0);
    glRectf(-1, -1, 1, 1);
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 99, 0, 0, 0);
    std::array<unsigned char, 4> colour{};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, colour.data());
    if (colour != last)
      std::printf("%d %d %d\n", colour[0], colour[1], colour[2]);
    if (!sameAsLoaded())
      std::puts("unlike what was loaded");
    std::fflush(stdout);
    last = colour;
    if (frames < 0)
      usleep(10000);
  }
  return 0;
}
