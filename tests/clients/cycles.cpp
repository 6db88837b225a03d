/// Creates contexts, draws in them and destroys them, repeatedly: memory must not grow. Each cycle
/// loads a vertex and a fragment program and a list of both. Every other context shares objects
/// with one that stays, and every fourth is destroyed while it is current.
/// argv[1]: cycles. Prints {"cycles": n, "kilobytes": growth of the resident set after the
/// warm-up}.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <unistd.h>

#define GL_GLEXT_PROTOTYPES
#include "body.h"
#include "egl_surface.h"

using namespace clients;

namespace {

constexpr const char kVertices[] = "!!ARBvp1.0\nPARAM m[4] = { state.matrix.mvp };\n"
                                   "DP4 result.position.x, m[0], vertex.position;\n"
                                   "DP4 result.position.y, m[1], vertex.position;\n"
                                   "DP4 result.position.z, m[2], vertex.position;\n"
                                   "DP4 result.position.w, m[3], vertex.position;\n"
                                   "MUL result.color, vertex.color, program.env[0];\nEND";
constexpr const char kFragments[] = "!!ARBfp1.0\nMUL result.color, fragment.color, "
                                    "program.local[0];\nEND";

long residentKilobytes() {
  long size = 0, resident = 0;
  FILE *const file = std::fopen("/proc/self/statm", "r");
  if (!file || std::fscanf(file, "%ld %ld", &size, &resident) != 2)
    die("no /proc/self/statm");
  std::fclose(file);
  return resident * (sysconf(_SC_PAGESIZE) / 1024);
}

GLuint load(GLenum target, const char *text) {
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glBindProgramARB(target, name);
  glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(std::strlen(text)), text);
  glEnable(target);
  return name;
}

/// Draws a quad in the programs' color; returns true if it is right.
bool draw(bool deletes) {
  glViewport(0, 0, 16, 16);
  const GLuint vertex = load(GL_VERTEX_PROGRAM_ARB, kVertices);
  const GLuint fragment = load(GL_FRAGMENT_PROGRAM_ARB, kFragments);
  glProgramEnvParameter4fARB(GL_VERTEX_PROGRAM_ARB, 0, 1, 0.5f, 1, 1);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 1, 1, 0.25f, 1);
  glColor4f(1, 1, 1, 1);
  glRectf(-1, -1, 1, 1);
  glEndList();
  glCallList(list);
  unsigned char pixel[4] = {};
  glReadPixels(8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  if (deletes) { // the application must delete what else stays in the share group
    glDeleteProgramsARB(1, &vertex);
    glDeleteProgramsARB(1, &fragment);
    glDeleteLists(list, 1);
  }
  return pixel[0] == 255 && std::abs(pixel[1] - 128) <= 1 && std::abs(pixel[2] - 64) <= 1;
}

} // namespace

int main(int argc, char **argv) {
  const int cycles = argc > 1 ? std::atoi(argv[1]) : 1000;
  const int warmUp = std::max(cycles / 4, 1);
  Egl egl;
#define X(name) egl.name = ::egl##name;
  CLIENT_EGL_FUNCTIONS(X)
#undef X
  EglSurface base = openSurface(egl);
  long before = 0;
  int wrong = 0;
  for (int i = 0; i < cycles; ++i) {
    if (i == warmUp)
      before = residentKilobytes();
    const bool shared = i % 2 != 0;
    const EGLContext context = eglCreateContext(base.display, base.config,
                                                shared ? base.context : EGL_NO_CONTEXT, nullptr);
    if (!eglMakeCurrent(base.display, base.surface, base.surface, context))
      die("no context");
    wrong += !draw(shared);
    if (i % 4 == 3)
      eglDestroyContext(base.display, context);
    // The group's other context can now delete the host objects of a dead one.
    eglMakeCurrent(base.display, base.surface, base.surface, base.context);
    if (i % 4 != 3)
      eglDestroyContext(base.display, context);
  }
  std::printf("{\"cycles\": %d, \"kilobytes\": %ld, \"wrong\": %d}\n", cycles,
              residentKilobytes() - before, wrong);
  closeSurface(egl, base);
  return wrong != 0;
}
