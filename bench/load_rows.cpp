#include "rows.h"

#include "common/program.h"

#include <chrono>
#include <cstdio>
#include <random>
#include <string>

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;

/// Returns a demonstration's text. A constant that nothing reads makes it a new one, so that no
/// cache knows it.
std::string demoText(unsigned seed) {
  std::string text(demos::kProgramTexts[seed % demos::kProgramTextCount].text);
  text.insert(text.rfind("END"), "PARAM unread = {" + std::to_string(seed) + ".5};\n");
  return text;
}

} // namespace

std::string generateText(unsigned seed) {
  static constexpr const char *kBinary[] = {"ADD", "SUB", "MUL", "MIN", "MAX", "DP3", "DP4", "SGE"};
  static constexpr const char *kMasks[] = {"", ".xyz", ".xy", ".w"};
  static constexpr const char *kSwizzles[] = {"", ".yzxw", ".xxxx", ".wzyx"};
  std::mt19937 random(seed);
  const auto pick = [&](unsigned n) { return unsigned(random() % n); };
  const unsigned samples = pick(5), alu = 4 + pick(45);
  std::string text = "!!ARBfp1.0\nTEMP r0, r1, r2, r3, r4, r5;\nPARAM c = {" +
                     std::to_string(seed % 9973) + ".25, 0.5, 0.125, 2.0};\n";
  text += "MOV r0, fragment.color;\nMOV r1, fragment.texcoord[0];\nMOV r2, c;\n";
  text += "MOV r3, program.local[0];\nMOV r4, fragment.texcoord[1];\nMOV r5, r0;\n";
  for (unsigned i = 0; i < samples; ++i)
    text += "TEX r" + std::to_string(i) + ", fragment.texcoord[" + std::to_string(i % 2) +
            "], texture[" + std::to_string(i) + "], 2D;\n";
  const auto reg = [&] { return "r" + std::to_string(pick(6)); };
  const auto operand = [&] {
    return (pick(4) == 0 ? "-" : "") + (pick(5) == 0 ? std::string("c") : reg()) +
           kSwizzles[pick(4)];
  };
  for (unsigned i = 0; i < alu; ++i) {
    const std::string to = reg() + kMasks[pick(4)];
    switch (pick(6)) {
    case 0:
      text += "MAD " + to + ", " + operand() + ", " + operand() + ", " + operand() + ";\n";
      break;
    case 1:
      text += "LRP_SAT " + to + ", " + operand() + ", " + operand() + ", " + operand() + ";\n";
      break;
    case 2:
      text += (pick(2) ? "RCP " : "EX2 ") + to + ", r" + std::to_string(pick(6)) + ".x;\n";
      break;
    default:
      text +=
          std::string(kBinary[pick(8)]) + " " + to + ", " + operand() + ", " + operand() + ";\n";
    }
  }
  text += "ADD r0, r0, r1;\nADD r0, r0, r2;\nADD r0, r0, r3;\nADD r0, r0, r4;\n";
  return text + "ADD result.color, r0, r5;\nEND\n";
}

namespace {

/// Returns the time from the program's name to its first pixels; negative if GL rejects it.
double loadAndDraw(const std::string &text) {
  const auto begin = Clock::now();
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, name);
  glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()),
                     text.data());
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glBegin(GL_TRIANGLES);
  glVertex2f(0.0f, 0.0f);
  glVertex2f(0.05f, 0.0f);
  glVertex2f(0.05f, 0.05f);
  glEnd();
  glFinish();
  const std::chrono::duration<double, std::nano> time = Clock::now() - begin;
  const bool rejected = glGetError() != GL_NO_ERROR;
  if (rejected)
    std::fprintf(stderr, "rejected: %s\n%s",
                 reinterpret_cast<const char *>(glGetString(GL_PROGRAM_ERROR_STRING_ARB)),
                 text.c_str());
  glDeleteProgramsARB(1, &name);
  return rejected ? -1.0 : time.count();
}

template <typename MakeText>
std::vector<double> loadEach(int count, unsigned seed, MakeText makeText) {
  std::vector<double> times(std::size_t(count), 0.0);
  for (double &time : times)
    time = loadAndDraw(makeText(seed++));
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
  return times;
}

std::vector<double> demoPrograms(int count, unsigned seed) {
  return loadEach(count, seed, demoText);
}

std::vector<double> generatedPrograms(int count, unsigned seed) {
  return loadEach(count, seed, generateText);
}

} // namespace

const std::vector<Row> &loadRows() {
  static const std::vector<Row> rows = {
      {"load/demo programs", demoPrograms},
      {"load/generated programs", generatedPrograms},
  };
  return rows;
}

} // namespace bench
