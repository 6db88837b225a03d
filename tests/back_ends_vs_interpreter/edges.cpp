#include "edges.h"

#include <array>
#include <cmath>

#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/testing/specials.h"
#include "tolerance.h"

namespace arbiter::differential {

using namespace fp::ir;

namespace {
using fp::testing::kInf;
using fp::testing::kNan;

constexpr std::array<float, kSide> kSpecial = {0.0f,  -0.0f,  1.0f,   -1.0f,    0.5f,   2.0f,
                                               -2.5f, kInf,   -kInf,  kNan,     1e-40f, -1e-40f,
                                               1e30f, -1e30f, 130.0f, 0x1p-100f};

/// Returns texel (x, y): a pair and, in z and w, two more values that differ from pixel to pixel.
Vec4 texelAt(int x, int y) {
  const auto at = [](int i) { return comparable(kSpecial[std::size_t(i % kSide)]); };
  return {at(x), at(y), at(x + 3 * y), at(5 * x + y)};
}

void bindTexels() {
  std::vector<float> values;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const Vec4 value = texelAt(x, y);
      values.insert(values.end(), value.begin(), value.end());
    }
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kSide, kSide, 0, GL_RGBA, GL_FLOAT, values.data());
}

std::string programText(Opcode op, bool saturate) {
  const OpInfo &row = info(op);
  std::string text = "!!ARBfp1.0\nTEMP t, r;\nMUL t, fragment.position, 0.0625;\n"
                     "TEX t, t, texture[0], 2D;\n";
  constexpr const char *kScalars[] = {"t.x", "t.y"};
  constexpr const char *kVectors[] = {"t", "t.yxwz", "t.zwxy"};
  std::string statement = std::string(row.mnemonic) + (saturate ? "_SAT" : "");
  if (!row.has(Kills))
    statement += " r,";
  for (int i = 0; i < row.operandCount(); ++i)
    statement += std::string(i ? ", " : " ") + (row.shapes[i] == 'S' ? kScalars[i] : kVectors[i]);
  if (op == Opcode::Swz)
    statement += ", -y, 1, 0, -x";
  text += statement + ";\nMOV result.color, " + (row.has(Kills) ? "1.0" : "r") + ";\nEND\n";
  return text;
}

/// Returns false if semantics.h leaves the result to the host, if it depends on rounding between
/// product and sum (1e30 * 1e30 - infinity), or if a function's tolerance is meaningless.
bool isDefined(Opcode op, bool saturate, const Vec4 &texel, fp::Numerics numerics) {
  const auto any = [&](bool (*test)(float)) {
    return test(texel[0]) || test(texel[1]) || test(texel[2]) || test(texel[3]);
  };
  switch (op) {
  case Opcode::Sin:
  case Opcode::Cos:
  case Opcode::Scs:
    return !(std::fabs(texel[0]) > 4.0f && std::isfinite(texel[0]));
  case Opcode::Lrp:
    if (numerics == fp::Numerics::Host)
      return !any([](float value) { return std::fabs(value) > 1e4f; });
    [[fallthrough]];
  case Opcode::Dp3:
  case Opcode::Dp4:
  case Opcode::Dph:
  case Opcode::Mad:
  case Opcode::Xpd:
    return numerics == fp::Numerics::Fp24 ||
           !any([](float value) { return std::fabs(value) > 1e4f && std::isfinite(value); });
  case Opcode::Abs:
    return !saturate || !any([](float value) { return std::isnan(value); });
  default:
    return true;
  }
}

bool agree(Opcode op, float seen, float expected, fp::Numerics numerics) {
  if (std::isnan(expected) || std::isnan(seen))
    return std::isnan(expected) && std::isnan(seen);
  if (std::isinf(expected) || std::isinf(seen))
    return seen == expected;
  const Tolerance allowed = tolerance(op, numerics);
  return std::fabs(seen - expected) <=
         (allowed.relative + 8 * allowed.operand) * std::fabs(expected) + allowed.absolute + 1e-37f;
}

std::string numbers(const Vec4 &value) {
  char text[96];
  std::snprintf(text, sizeof text, "(%g, %g, %g, %g)", double(value[0]), double(value[1]),
                double(value[2]), double(value[3]));
  return text;
}

class Edges {
public:
  Edges(Backend &backend, const SuiteOptions &options) : m_backend(backend), m_options(options) {}

  Report run() {
    if (!begin(m_report, m_target))
      return m_report;
    bindTexels();
    for (int op = 0; op < fp::ir::kFragmentOpcodeCount; ++op) {
      const OpInfo &row = info(Opcode(op));
      if (row.has(Texture))
        continue;
      one(Opcode(op), false);
      if (!row.has(Kills))
        one(Opcode(op), true);
    }
    return m_report;
  }

private:
  void one(Opcode op, bool saturate) {
    ++m_report.programs;
    const std::string text = programText(op, saturate);
    const fp::CheckResult checked =
        fp::checkFragmentProgram(text, {suiteLimits(), fp::LimitPolicy::Enforce});
    if (!checked.ok())
      return fail(op, checked.errorString(text));
    std::string problem = m_backend.use({text, *checked.program});
    m_target.clear();
    glRectf(-1, -1, 1, 1);
    if (problem.empty())
      problem = takeErrors();
    if (!problem.empty())
      return fail(op, problem);
    const Pixels pixels = m_target.read(0);
    int wrong = 0;
    std::string first;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const std::string difference = compare(op, saturate, *checked.program, pixels, x, y);
        if (!difference.empty() && wrong++ == 0)
          first = difference;
      }
    if (wrong != 0)
      fail(op, std::string(saturate ? "_SAT " : "") + std::to_string(wrong) +
                   " of 256 pixels, first: " + first);
  }

  std::string compare(Opcode op, bool saturate, const Program &program, const Pixels &pixels, int x,
                      int y) {
    const Vec4 texel = texelAt(x, y);
    const fp::Numerics numerics = m_options.numerics;
    if (!isDefined(op, saturate, texel, numerics)) {
      m_report.skipped += 4;
      return "";
    }
    Inputs inputs;
    inputs.texture = [&](const Sample &) { return texel; };
    inputs.numerics = numerics;
    const Evaluation expected = evaluate(program, inputs);
    const float *rgba = &pixels.rgba[std::size_t(y * kSide + x) * 4];
    const Vec4 seen = {rgba[0], rgba[1], rgba[2], rgba[3]};
    m_report.compared += 4;
    if (expected.killed || seen[0] == kUntouched)
      return expected.killed == (seen[0] == kUntouched)
                 ? ""
                 : "texel " + numbers(texel) + (expected.killed ? " drawn" : " killed");
    for (std::size_t i = 0; i < 4; ++i)
      if (!agree(op, seen[i], expected.outputs[0][i], numerics))
        return "texel " + numbers(texel) + " gave " + numbers(seen) + ", expected " +
               numbers(expected.outputs[0]);
    return "";
  }

  void fail(Opcode op, const std::string &reason) {
    m_report.failures.push_back({std::uint64_t(op), std::string(info(op).mnemonic) + " " + reason});
  }

  Backend &m_backend;
  const SuiteOptions &m_options;
  FloatTarget m_target;
  Report m_report;
};
} // namespace

Report runEdges(Backend &backend, const SuiteOptions &options) {
  return Edges(backend, options).run();
}

} // namespace arbiter::differential
