#include "vertex_clip.h"

#include <algorithm>

#include "subject.h"
#include "vertex_reader.h"

namespace arbiter::differential {

namespace {
/// Sets a clip plane under matrices for which eye space and clip space differ, so that a plane in
/// the wrong space clips other pixels.
void applyPlane() {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-0.5, 0.5, -0.5, 0.5, 1, 10);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glTranslatef(0.1f, 0.2f, -2);
  glRotatef(30, 0.2f, 0.3f, 1);
  constexpr GLdouble kPlane[] = {1, 0.3, 0.2, 0.1};
  glClipPlane(GL_CLIP_PLANE0, kPlane);
  glEnable(GL_CLIP_PLANE0);
}

void drawSquare() {
  glBegin(GL_QUADS);
  glVertex2f(-1, -1);
  glVertex2f(1, -1);
  glVertex2f(1, 1);
  glVertex2f(-1, 1);
  glEnd();
}

std::vector<bool> covered(const FloatTarget &target) {
  const Drawn drawn(target);
  std::vector<bool> result;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      result.push_back(drawn.color(0, x, y)[0] != kUntouched);
  return result;
}

std::vector<bool> fixedFunction(const FloatTarget &target) {
  glUseProgram(0);
  glDisable(GL_VERTEX_PROGRAM_ARB);
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
  target.clear();
  drawSquare();
  return covered(target);
}

constexpr const char *kPrograms[] = {
    "!!ARBvp1.0\nOPTION ARB_position_invariant;\nMOV result.texcoord[0], vertex.position;\nEND\n",
    "!!ARBvp1.0\nPARAM m[4] = { state.matrix.mvp };\n"
    "DP4 result.position.x, m[0], vertex.position;\n"
    "DP4 result.position.y, m[1], vertex.position;\n"
    "DP4 result.position.z, m[2], vertex.position;\n"
    "DP4 result.position.w, m[3], vertex.position;\n"
    "MOV result.texcoord[0], vertex.position;\nEND\n"};
} // namespace

std::string clipDifference(Backend &backend, const FloatTarget &target) {
  applyPlane();
  const std::vector<bool> expected = fixedFunction(target);
  const auto count = std::count(expected.begin(), expected.end(), true);
  std::string difference =
      count == 0 || count == kSide * kSide ? "the plane clips nothing, or everything" : "";
  for (const std::string text : kPrograms) {
    const fp::CheckResult checked = fp::checkProgram(fp::ir::Language::ArbVertex, text,
                                                     {suiteLimits(), fp::LimitPolicy::Enforce});
    if (!checked.ok())
      return checked.errorString(text);
    const std::string problem = Reader(*checked.program)
                                    .draw(backend, text, *checked.program, target,
                                          [](const fp::ir::Program &) { drawSquare(); });
    if (!problem.empty())
      return problem;
    const std::vector<bool> seen = covered(target);
    if (difference.empty() && seen != expected)
      difference = std::to_string(std::count(seen.begin(), seen.end(), true)) + " pixels, " +
                   std::to_string(count) + " by fixed function:\n" + text;
  }
  glDisable(GL_CLIP_PLANE0);
  return difference;
}

} // namespace arbiter::differential
