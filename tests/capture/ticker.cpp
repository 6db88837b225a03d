// Draws one pixel repeatedly without a window, and prints its color as "R G B" whenever it changes.
// It never swaps buffers, sets a local parameter around each draw, queries its program string and
// counts, and reloads its program now and then, and one that is refused.
//
//   ticker [KIND [FRAMES]]     KIND: fragment, long (the same, with 16 KiB of comment), vertex or
//   ati
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <unistd.h>

#include "one_pixel.h"

#ifndef GL_TEXT_FRAGMENT_SHADER_ATI
#define GL_TEXT_FRAGMENT_SHADER_ATI 0x8200
#endif

namespace {

/// A program that draws green and reads program.local[0], and one that is refused. Each has a
/// Latin-1 byte in a comment.
struct Kind {
  const char *name;
  GLenum target;
  const char *program;
  const char *refused;
};
const std::string kLong = "!!ARBfp1.0\n#" + std::string(16384, 'x') +
                          "\nADD result.color, program.local[0].yyyy, {0, 1, 0, 1};\nEND\n";
const Kind kKinds[] = {
    {"long", GL_FRAGMENT_PROGRAM_ARB, kLong.c_str(),
     "!!ARBfp1.0\nMOV result.color, missing;\nEND\n"},
    {"fragment", GL_FRAGMENT_PROGRAM_ARB,
     "!!ARBfp1.0\n# caf\xe9\nADD result.color, program.local[0].yyyy, {0, 1, 0, 1};\nEND\n",
     "!!ARBfp1.0\n# \xe9\nMOV result.color, missing;\nEND\n"},
    {"vertex", GL_VERTEX_PROGRAM_ARB,
     "!!ARBvp1.0\n# caf\xe9\nMOV result.position, vertex.position;\n"
     "ADD result.color, program.local[0].y, {0, 1, 0, 1};\nEND\n",
     "!!ARBvp1.0\n# \xe9\nMOV result.color, missing;\nEND\n"},
    {"ati", GL_TEXT_FRAGMENT_SHADER_ATI,
     "!!ATIfs1.0\n# caf\xe9\nStartConstants;\nCONSTANT c0 = program.local[0];\n"
     "CONSTANT c1 = {0.0, 1.0, 0.0, 1.0};\nEndConstants;\n"
     "StartOutputPass;\nADD r0, c0.g, c1;\nEndPass;\n",
     "!!ATIfs1.0\n# \xe9\nStartOutputPass;\nMOV r0, missing;\nEndPass;\n"},
};

const Kind *findKind(const char *name) {
  for (const Kind &kind : kKinds)
    if (std::strcmp(kind.name, name) == 0)
      return &kind;
  return nullptr;
}

void load(const Kind &kind, GLuint name, const char *text) {
  glBindProgramARB(kind.target, name);
  glProgramStringARB(kind.target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(std::strlen(text)), text);
}

GLint instructions(const Kind &kind) {
  GLint count = 0;
  glGetProgramivARB(kind.target, GL_PROGRAM_INSTRUCTIONS_ARB, &count);
  return count;
}

std::string programString(const Kind &kind) {
  GLint length = 0;
  glGetProgramivARB(kind.target, GL_PROGRAM_LENGTH_ARB, &length);
  std::string text(std::size_t(length), '\0');
  glGetProgramStringARB(kind.target, GL_PROGRAM_STRING_ARB, text.data());
  return text;
}

void tick(const Kind &kind, long frames) {
  const GLint counted = instructions(kind);
  std::array<unsigned char, 4> last{1, 2, 3, 4};
  for (long frame = 0; frame != frames; ++frame) {
    if (frame % 20 == 10) { // a new object with the same text
      const GLuint name = 1;
      glDeleteProgramsARB(1, &name);
      load(kind, name, kind.program);
    }
    glProgramLocalParameter4fARB(kind.target, 0, GLfloat(frame), 0, 0, 0);
    glRectf(-1, -1, 1, 1);
    glProgramLocalParameter4fARB(kind.target, 0, 99, 0, 0, 0);
    std::array<unsigned char, 4> color{};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, color.data());
    if (color != last)
      std::printf("%d %d %d\n", color[0], color[1], color[2]);
    if (programString(kind) != kind.program || instructions(kind) != counted ||
        glGetError() != GL_NO_ERROR)
      std::puts("unlike what was loaded");
    std::fflush(stdout);
    last = color;
    if (frames < 0)
      usleep(10000);
  }
}

} // namespace

int main(int argc, char **argv) {
  const Kind *const kind = findKind(argc > 1 ? argv[1] : "fragment");
  if (!kind || !makeContext()) {
    std::puts(kind ? "no context" : "no such kind");
    return 1;
  }
  makeTarget();
  glEnable(kind->target);
  load(*kind, 2, kind->refused);
  if (glGetError() == GL_NO_ERROR)
    std::puts("accepted");
  load(*kind, 1, kind->program);
  tick(*kind, argc > 2 ? std::atol(argv[2]) : -1);
  return 0;
}
