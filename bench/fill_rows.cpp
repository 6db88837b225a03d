#include "quad.h"
#include "rows.h"

#include <chrono>
#include <epoxy/gl.h>
#include <functional>
#include <map>
#include <string>

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;

/// Loads each text only once, as the cost of a frame is measured and not that of a compiler.
void load(std::string_view text) {
  static std::map<std::string, GLuint, std::less<>> s_programs;
  const auto known = s_programs.find(text);
  if (known != s_programs.end())
    return glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, known->second);
  GLuint program = 0;
  glGenProgramsARB(1, &program);
  s_programs.emplace(text, program);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, program);
  glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()),
                     text.data());
  for (GLuint i = 0; i < 4; ++i)
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, i, 0.5f, 0.25f, 0.75f, 1.0f);
}

/// Returns the nanoseconds of a frame of the whole surface, after one that is not counted.
double frame(std::string_view text, int count) {
  bindTextures();
  load(text);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  drawQuad();
  glFinish();
  const auto begin = Clock::now();
  for (int i = 0; i < count; ++i)
    drawQuad();
  glFinish();
  const std::chrono::duration<double, std::nano> time = Clock::now() - begin;
  return time.count() / count;
}

/// Returns a program with sixteen multiplications of two registers.
std::string multiplying(const char *first, const char *second, const char *saturated) {
  const std::string sat = saturated;
  std::string text =
      std::string("!!ARBfp1.0\nTEMP a, b, c;\n") + first + "\n" + second + "\nMOV c, a;\n";
  for (int i = 0; i < 4; ++i)
    text += "MUL" + sat + " c, c, b;\nMAD" + sat + " c, a, b.wzyx, c;\nDP3" + sat +
            " c.xy, c, a;\nLRP" + sat + " c, a, c, b;\n";
  return text + "MOV result.color, c;\nEND\n";
}

/// Measures operands in [0,1]: colors, constants, and results of _SAT.
std::vector<double> finite(int count, unsigned) {
  static const std::string s_text =
      multiplying("MUL_SAT a, fragment.color, {0.5, 0.25, 0.75, 1.0};",
                  "ADD_SAT b, fragment.color.yzxw, {0.25, 0.5, 0.0, 0.125};", "_SAT");
  return {frame(s_text, count)};
}

/// Measures operands of unknown range: texture coordinates and parameters.
std::vector<double> any(int count, unsigned) {
  static const std::string s_text =
      multiplying("MOV a, fragment.texcoord[0];", "MUL b, program.local[0], program.local[1];", "");
  return {frame(s_text, count)};
}

/// Measures a typical program of the era: samples times a color and parameters.
std::vector<double> textured(int count, unsigned) {
  return {frame("!!ARBfp1.0\nTEMP a, b;\nTEX a, fragment.texcoord[0], texture[0], 2D;\n"
                "TEX b, fragment.texcoord[1], texture[1], 2D;\nMUL a, a, fragment.color;\n"
                "MAD a, b, program.local[0], a;\nLRP a, fragment.color.w, a, b;\n"
                "MUL result.color, a, 2.0;\nEND\n",
                count)};
}

/// Measures the sum of the frames of twelve generated programs.
std::vector<double> generated(int count, unsigned) {
  double sum = 0;
  for (unsigned seed = 1; seed <= 12; ++seed)
    sum += frame(generateText(seed), count);
  return {sum};
}

} // namespace

const std::vector<Row> &fillRows() {
  static const std::vector<Row> rows = {
      {"fill/operands proved finite", finite},
      {"fill/operands of any value", any},
      {"fill/textures, colour, parameters", textured},
      {"fill/12 generated programs", generated},
  };
  return rows;
}

} // namespace bench
