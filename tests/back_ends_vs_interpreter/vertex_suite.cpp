#include "vertex_suite.h"

#include <cmath>

#include "expectation.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/testing/random.h"
#include "mutate.h"
#include "scene_data.h"
#include "vertex_reader.h"

namespace arbiter::differential {

using namespace fp::ir;

namespace {
class VertexSuite {
public:
  VertexSuite(Backend &backend, const SuiteOptions &options)
      : m_backend(backend), m_options(options) {}

  Report run() {
    if (!begin(m_report, m_target))
      return m_report;
    applyState(m_backend.hasProgramMatrices());
    applyTextures();
    if (const std::string errors = takeErrors(); !errors.empty())
      m_report.failures.push_back({0, "GL errors while the scene was set: " + errors});
    for (int i = 0; i < m_options.count; ++i)
      one(m_options.firstSeed + std::uint64_t(i));
    return m_report;
  }

private:
  void one(std::uint64_t seed) {
    ++m_report.programs;
    const Subject subject = m_options.subject(seed);
    const std::string &text = subject.text;
    if (!subject.program)
      return fail(seed, text, "refused: " + subject.error);
    const Program &program = *subject.program;
    const Reader reader(program);
    std::string problem = reader.draw(m_backend, text, program, m_target);
    if (!problem.empty())
      return fail(seed, text, problem);
    const Program expected = m_options.mutate ? mutant(program, seed, m_options.numerics) : program;
    const Verdict worst = compare(seed, program, reader, reader.shown(expected));
    if (worst.error > 1)
      return fail(seed, text,
                  worst.what + "\n" + fp::emitGlsl(program, {}, m_options.numerics).text);
    m_report.worst = std::max(m_report.worst, worst.error);
  }

  /// True if every component of the position is written. Without a w nothing is drawn.
  static bool hasPosition(const Program &program) {
    unsigned written = program.options.positionInvariant ? 0xF : 0;
    for (const Instruction &instruction : program.code)
      if (instruction.dst.file == File::Output &&
          program.outputs[instruction.dst.index].kind == OutputKind::Position)
        written |= writeMask(instruction);
    return written == 0xF;
  }

  Verdict nothing(const Drawn &drawn) {
    Verdict verdict;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x, ++verdict.compared)
        if (drawn.color(0, x, y) != Vec4{kUntouched, kUntouched, kUntouched, kUntouched}) {
          verdict.error = 2;
          verdict.what = "drawn without a position";
        }
    m_report.compared += std::uint64_t(verdict.compared);
    return verdict;
  }

  Verdict compare(std::uint64_t seed, const Program &drawnProgram, const Reader &reader,
                  const Program &program) {
    const Drawn drawn(m_target);
    if (!hasPosition(drawnProgram))
      return nothing(drawn);
    Verdict worst;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        PixelInputs inputs;
        inputs.numerics = m_options.numerics;
        for (const Attribute &attribute : program.attributes)
          inputs.attributes.push_back(vertexValue(attribute, x, y));
        const auto judged = [&](int trials) {
          const auto pixel = std::uint64_t(y * kSide + x);
          const ExpectedPixel expected = expect(program, inputs, seed * 1000 + pixel, trials);
          return judge(program, expected, reader.seen(drawn, x, y, expected), 0);
        };
        Verdict verdict = judged(kFewTrials);
        if (verdict.error > 1)
          verdict = judged(kManyTrials);
        const float depth = depthOf(vertexValue({AttributeKind::Position, 0}, x, y)[2]);
        if (std::fabs(drawn.depth(x, y) - depth) > 1e-6f) {
          verdict.error = 2;
          verdict.what =
              "depth " + std::to_string(drawn.depth(x, y)) + ", expected " + std::to_string(depth);
        }
        m_report.compared += std::uint64_t(verdict.compared);
        m_report.skipped += std::uint64_t(verdict.skipped);
        if (verdict.error > worst.error) {
          worst = verdict;
          worst.what += " at vertex " + std::to_string(x) + "," + std::to_string(y);
        }
      }
    return worst;
  }

  static float depthOf(float z) { return kDepthNear + (kDepthFar - kDepthNear) * (z + 1) / 2; }

  void fail(std::uint64_t seed, const std::string &text, const std::string &problem) {
    writeFailure(m_options.failures, seed, text, problem, {}, {});
    m_report.failures.push_back({seed, problem.substr(0, problem.find('\n'))});
  }

  Backend &m_backend;
  const SuiteOptions &m_options;
  FloatTarget m_target;
  Report m_report;
};
} // namespace

Report runVertexSuite(Backend &backend, const SuiteOptions &options) {
  return VertexSuite(backend, options).run();
}

} // namespace arbiter::differential
