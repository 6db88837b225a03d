#include "vertex_reader.h"

#include <algorithm>

#include "fp_compiler/ir/print.h"
#include "suite.h"

namespace arbiter::differential {

using namespace fp::ir;

namespace {
/// Returns the fragment attribute that a result becomes.
Attribute attributeOf(const Output &result) {
  switch (result.kind) {
  case OutputKind::FrontPrimary:
    return {AttributeKind::ColorPrimary, 0};
  case OutputKind::FrontSecondary:
    return {AttributeKind::ColorSecondary, 0};
  case OutputKind::FogCoord:
    return {AttributeKind::FogCoord, 0};
  default:
    return {AttributeKind::TexCoord, result.index};
  }
}

bool isShown(const Output &output) {
  return output.kind == OutputKind::FrontPrimary || output.kind == OutputKind::FrontSecondary ||
         output.kind == OutputKind::FogCoord || output.kind == OutputKind::TexCoord;
}
} // namespace

Drawn::Drawn(const FloatTarget &target) {
  for (int i = 0; i < kColorBuffers; ++i)
    m_pixels[std::size_t(i)] = target.read(i);
}

Vec4 Drawn::color(int buffer, int x, int y) const {
  const float *rgba = &m_pixels[std::size_t(buffer)].rgba[std::size_t(y * kSide + x) * 4];
  return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

float Drawn::depth(int x, int y) const { return m_pixels[0].depth[std::size_t(y * kSide + x)]; }

Reader::Reader(const Program &vertexProgram) {
  for (const Output &output : vertexProgram.outputs)
    if (isShown(output) && m_results.size() < kColorBuffers)
      m_results.push_back(output);
}

std::string Reader::draw(Backend &backend, const std::string &text, const Program &program,
                         const FloatTarget &target, void (*points)(const Program &)) const {
  std::string copies = "!!ARBfp1.0\nOPTION ARB_draw_buffers;\n";
  for (std::size_t i = 0; i < m_results.size(); ++i)
    copies += "MOV result.color[" + std::to_string(i) + "], " +
              bindingText(attributeOf(m_results[i])) + ";\n";
  copies += "END\n";
  const fp::CheckResult checked =
      fp::checkFragmentProgram(copies, {suiteLimits(), fp::LimitPolicy::Enforce});
  if (!checked.ok())
    return checked.errorString(copies);
  const Stage vertex{text, program};
  const std::string problem = backend.use({copies, *checked.program}, &vertex);
  if (!problem.empty())
    return problem;
  target.clear();
  points(program);
  glFinish();
  return takeErrors();
}

Program Reader::shown(Program program) const {
  for (Output &output : program.outputs) {
    const auto at = std::find(m_results.begin(), m_results.end(), output) - m_results.begin();
    const bool hidden = std::size_t(at) == m_results.size();
    output = {OutputKind::Color, std::uint8_t(hidden ? kColorBuffers : at)};
  }
  return program;
}

std::array<Vec4, kColorBuffers> Reader::seen(const Drawn &drawn, int x, int y,
                                             const ExpectedPixel &expected) const {
  std::array<Vec4, kColorBuffers> colors = {};
  for (std::size_t b = 0; b < m_results.size(); ++b) {
    colors[b] = drawn.color(int(b), x, y);
    if (m_results[b].kind == OutputKind::FogCoord)
      for (std::size_t i = 1; i < 4; ++i)
        colors[b][i] = expected.colors[b][i].value;
  }
  return colors;
}

} // namespace arbiter::differential
