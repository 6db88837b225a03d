#include "rows.h"

#include <chrono>
#include <epoxy/gl.h>

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kDraws = 10000;

/// Prepares a quad of about four pixels, so that the call is measured and not the fill.
void prepareQuad() {
  static constexpr float kQuad[8] = {0.0f, 0.0f, 0.004f, 0.0f, 0.004f, 0.004f, 0.0f, 0.004f};
  static GLuint buffer = 0;
  if (!buffer) {
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof kQuad, kQuad, GL_STATIC_DRAW);
  }
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  glEnableClientState(GL_VERTEX_ARRAY);
  glColor4f(1, 1, 1, 1);
}

void prepareFragments(GLuint &program) {
  if (!program) {
    static constexpr std::string_view kText = "!!ARBfp1.0\nPARAM tint = program.local[0];\nMUL "
                                              "result.color, fragment.color, tint;\nEND\n";
    glGenProgramsARB(1, &program);
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, program);
    glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(kText.size()),
                       kText.data());
  }
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, program);
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 1, 1, 1, 1);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  prepareQuad();
}

void prepare() {
  static GLuint program = 0;
  prepareFragments(program);
}
/// Prepares the row that changes its parameters. A driver, or the layer, may choose how to draw by
/// how often that happened, so that this row has a program of its own.
void prepareChanging() {
  static GLuint program = 0;
  prepareFragments(program);
}

/// Prepares a vertex and a fragment program.
void preparePair() {
  static GLuint program = 0;
  if (!program) {
    static constexpr std::string_view kText =
        "!!ARBvp1.0\nPARAM mvp[4] = { state.matrix.mvp };\n"
        "DP4 result.position.x, mvp[0], vertex.position;\n"
        "DP4 result.position.y, mvp[1], vertex.position;\n"
        "DP4 result.position.z, mvp[2], vertex.position;\n"
        "DP4 result.position.w, mvp[3], vertex.position;\n"
        "MUL result.color, vertex.color, program.local[0];\nEND\n";
    glGenProgramsARB(1, &program);
    glBindProgramARB(GL_VERTEX_PROGRAM_ARB, program);
    glProgramStringARB(GL_VERTEX_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(kText.size()),
                       kText.data());
  }
  prepare();
  glBindProgramARB(GL_VERTEX_PROGRAM_ARB, program);
  glProgramLocalParameter4fARB(GL_VERTEX_PROGRAM_ARB, 0, 1, 1, 1, 1);
  glEnable(GL_VERTEX_PROGRAM_ARB);
}

/// Prepares a vertex program with fixed-function fragments.
void prepareVertex() {
  preparePair();
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
}

/// Returns the time of \p count frames of kDraws draws each, including glFinish.
template <typename Draw>
std::vector<double> frames(int count, Draw draw, void (*setUp)() = prepare) {
  setUp();
  glFinish();
  const auto begin = Clock::now();
  for (int frame = 0; frame < count; ++frame) {
    for (int i = 0; i < kDraws; ++i)
      draw(i);
    glFinish();
  }
  const std::chrono::duration<double, std::nano> time = Clock::now() - begin;
  glDisable(GL_VERTEX_PROGRAM_ARB);
  return {time.count() / count};
}

std::vector<double> vertexArrays(int count, unsigned) {
  return frames(
      count, [](int) { glDrawArrays(GL_TRIANGLE_FAN, 0, 4); }, prepareVertex);
}
std::vector<double> pairArrays(int count, unsigned) {
  return frames(
      count, [](int) { glDrawArrays(GL_TRIANGLE_FAN, 0, 4); }, preparePair);
}
std::vector<double> pairArraysWithLocals(int count, unsigned) {
  return frames(
      count,
      [](int i) {
        glProgramLocalParameter4fARB(GL_VERTEX_PROGRAM_ARB, 0, float(i & 255) / 255.0f, 1, 1, 1);
        glDrawArrays(GL_TRIANGLE_FAN, 0, 4);
      },
      preparePair);
}

std::vector<double> arrays(int count, unsigned) {
  return frames(count, [](int) { glDrawArrays(GL_TRIANGLE_FAN, 0, 4); });
}
std::vector<double> arraysWithLocals(int count, unsigned) {
  return frames(
      count,
      [](int i) {
        glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, float(i & 255) / 255.0f, 1, 1, 1);
        glDrawArrays(GL_TRIANGLE_FAN, 0, 4);
      },
      prepareChanging);
}
std::vector<double> immediate(int count, unsigned) {
  return frames(count, [](int i) {
    glBegin(GL_TRIANGLE_FAN);
    glColor4f(float(i & 255) / 255.0f, 1, 1, 1);
    glVertex2f(0.0f, 0.0f);
    glVertex2f(0.004f, 0.0f);
    glVertex2f(0.004f, 0.004f);
    glVertex2f(0.0f, 0.004f);
    glEnd();
  });
}

} // namespace

const std::vector<Row> &drawRows() {
  static const std::vector<Row> rows = {
      {"draws/10000 glDrawArrays", arrays},
      {"draws/10000 parameter + glDrawArrays", arraysWithLocals},
      {"draws/10000 glBegin..glEnd", immediate},
      {"draws/10000 glDrawArrays, vertex program", vertexArrays},
      {"draws/10000 glDrawArrays, both programs", pairArrays},
      {"draws/10000 vertex parameter + glDrawArrays", pairArraysWithLocals},
  };
  return rows;
}

} // namespace bench
