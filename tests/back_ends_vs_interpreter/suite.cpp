#include "suite.h"

#include <cmath>
#include <map>

#include "expectation.h"
#include "fp_compiler/ir/print.h"
#include "mutate.h"

namespace arbiter::differential {

using namespace fp::ir;

namespace {
struct Optioned {
  Attribute attribute;
  bool upperLeft, integer;
  auto operator<=>(const Optioned &o) const {
    return std::tuple(attribute.kind, attribute.index, upperLeft, integer) <=>
           std::tuple(o.attribute.kind, o.attribute.index, o.upperLeft, o.integer);
  }
};

fp::CheckResult check(const std::string &text) {
  return fp::checkFragmentProgram(text, {suiteLimits(), fp::LimitPolicy::Enforce});
}

class Suite {
public:
  Suite(Backend &backend, const SuiteOptions &options) : m_backend(backend), m_options(options) {}

  Report run() {
    if (!begin(m_report, m_target))
      return m_report;
    applyState(m_backend.hasProgramMatrices());
    applyTextures(m_backend.hasProgramMatrices());
    if (const std::string errors = takeErrors(); !errors.empty())
      m_report.failures.push_back({0, "GL errors while the scene was set: " + errors});
    for (int i = 0; i < m_options.count; ++i)
      one(m_options.firstSeed + std::uint64_t(i));
    return m_report;
  }

private:
  /// The inputs of stages after the program, as this host interpolates them.
  struct Pipeline {
    const std::vector<float> &fogCoordinate;
    const std::vector<float> &secondary;
  };

  void fail(std::uint64_t seed, const std::string &reason) {
    m_report.failures.push_back({seed, reason});
  }

  /// Draws with the backend's current program.
  std::string draw() {
    m_target.clear();
    drawQuad();
    glFinish();
    return takeErrors();
  }

  /// Measures the attribute as this host interpolates it, which the program under test will read.
  /// The result is checked against what was sent, so that a mix-up of attributes is noticed.
  const std::vector<float> &measured(const Attribute &attribute, const Options &options) {
    const bool position = attribute.kind == AttributeKind::Position;
    const Optioned key{attribute, position && options.originUpperLeft,
                       position && options.pixelCenterInteger};
    const auto found = m_measured.find(key);
    if (found != m_measured.end())
      return found->second;
    std::string text = "!!ARBfp1.0\n";
    if (attribute.kind == AttributeKind::Facing)
      text += "OPTION NV_fragment_program2;\n";
    if (key.upperLeft)
      text += "OPTION ARB_fragment_coord_origin_upper_left;\n";
    if (key.integer)
      text += "OPTION ARB_fragment_coord_pixel_center_integer;\n";
    text += "MOV result.color, " + bindingText(attribute) + ";\nEND\n";
    const fp::CheckResult checked = check(text);
    // The measuring program must not apply the numerics mode, as that is under test.
    const auto raw = m_options.numerics == fp::Numerics::Host ? nullptr : glslBackend();
    std::string problem = (raw ? *raw : m_backend).use({text, *checked.program});
    if (problem.empty())
      problem = draw();
    std::vector<float> &values = m_measured[key] = m_target.read(0).rgba;
    if (problem.empty())
      problem = verify(key, values);
    if (!problem.empty())
      fail(0, bindingText(attribute) + ": " + problem);
    return values;
  }

  static std::string verify(const Optioned &key, const std::vector<float> &values) {
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        Vec4 sent = attributeValue(key.attribute, float(x) + 0.5f, float(y) + 0.5f);
        if (key.upperLeft)
          sent[1] = kSide - sent[1];
        if (key.integer) {
          sent[0] -= 0.5f;
          sent[1] -= 0.5f;
        }
        // The fourth component of a secondary color is host-dependent: 0 or 1. So are all but the
        // first of the facing.
        const std::size_t count = key.attribute.kind == AttributeKind::ColorSecondary ? 3
                                  : key.attribute.kind == AttributeKind::Facing       ? 1
                                                                                      : 4;
        for (std::size_t i = 0; i < count; ++i) {
          const float seen = values[std::size_t(y * kSide + x) * 4 + i];
          if (!(std::fabs(seen - sent[i]) < 1e-4f))
            return "component " + std::to_string(i) + " is " + std::to_string(seen) + " at " +
                   std::to_string(x) + "," + std::to_string(y) + ", sent " +
                   std::to_string(sent[i]);
        }
      }
    return "";
  }

  void one(std::uint64_t seed) {
    ++m_report.programs;
    const Subject subject = m_options.subject(seed);
    const std::string &text = subject.text;
    if (!subject.program)
      return fail(seed, "refused: " + subject.error);
    const Program &program = *subject.program;
    std::vector<const std::vector<float> *> attributes;
    for (const Attribute &attribute : program.attributes)
      attributes.push_back(&measured(attribute, program.options));
    const Pipeline pipeline{measured({AttributeKind::FogCoord, 0}, {}),
                            measured({AttributeKind::ColorSecondary, 0}, {})};
    std::string problem = m_backend.use({text, program});
    if (problem.empty())
      problem = draw();
    if (!problem.empty()) {
      writeFailure(m_options.failures, seed, text, problem, {}, {});
      return fail(seed, problem.substr(0, problem.find('\n')));
    }
    compare(seed, text, m_options.mutate ? mutant(program, seed, m_options.numerics) : program,
            attributes, pipeline);
  }

  [[nodiscard]] PixelInputs inputsAt(const std::vector<const std::vector<float> *> &attributes,
                                     const Pipeline &pipeline, std::size_t pixel) const {
    const auto rgba = [&](const std::vector<float> &values) {
      return Vec4{values[pixel * 4], values[pixel * 4 + 1], values[pixel * 4 + 2],
                  values[pixel * 4 + 3]};
    };
    PixelInputs inputs;
    for (const std::vector<float> *values : attributes)
      inputs.attributes.push_back(rgba(*values));
    inputs.fogCoordinate = pipeline.fogCoordinate[pixel * 4];
    inputs.secondary = rgba(pipeline.secondary);
    inputs.numerics = m_options.numerics;
    return inputs;
  }

  [[nodiscard]] ExpectedPixel expected(const Program &program,
                                       const std::vector<const std::vector<float> *> &attributes,
                                       const Pipeline &pipeline, std::uint64_t seed,
                                       std::size_t pixel, int trials) const {
    if (!needsQuads(program))
      return expect(program, inputsAt(attributes, pipeline, pixel), seed * 1000 + pixel, trials);
    const std::size_t x = pixel % kSide, y = pixel / kSide;
    const std::size_t first = (y & ~std::size_t(1)) * kSide + (x & ~std::size_t(1));
    std::array<PixelInputs, 4> quad;
    for (std::size_t i = 0; i < 4; ++i)
      quad[i] = inputsAt(attributes, pipeline, first + i / 2 * kSide + i % 2);
    return expect(program, quad, seed * 1000 + pixel, trials)[(y & 1) * 2 + (x & 1)];
  }

  void compare(std::uint64_t seed, const std::string &text, const Program &program,
               const std::vector<const std::vector<float> *> &attributes,
               const Pipeline &pipeline) {
    std::array<Pixels, kColorBuffers> seen;
    for (int i = 0; i < kColorBuffers; ++i)
      seen[std::size_t(i)] = m_target.read(i);
    std::vector<float> picture(std::size_t(kSide) * kSide * 4);
    Verdict worst;
    for (std::size_t pixel = 0; pixel < std::size_t(kSide) * kSide; ++pixel) {
      const auto rgba = [&](const std::vector<float> &values) {
        return Vec4{values[pixel * 4], values[pixel * 4 + 1], values[pixel * 4 + 2],
                    values[pixel * 4 + 3]};
      };
      const auto expectation = [&](int trials) {
        return expected(program, attributes, pipeline, seed, pixel, trials);
      };
      const ExpectedPixel expected = expectation(kFewTrials);
      for (std::size_t i = 0; i < 4; ++i)
        picture[pixel * 4 + i] = expected.killed ? kUntouched : expected.colors[0][i].value;
      std::array<Vec4, kColorBuffers> colors;
      for (std::size_t i = 0; i < kColorBuffers; ++i)
        colors[i] = rgba(seen[i].rgba);
      Verdict verdict = judge(program, expected, colors, seen[0].depth[pixel]);
      if (verdict.error > 1)
        verdict = judge(program, expectation(kManyTrials), colors, seen[0].depth[pixel]);
      m_report.compared += std::uint64_t(verdict.compared);
      m_report.skipped += std::uint64_t(verdict.skipped);
      if (verdict.error > worst.error) {
        worst = verdict;
        worst.what +=
            " at pixel " + std::to_string(pixel % kSide) + "," + std::to_string(pixel / kSide);
      }
    }
    if (worst.error <= 1) {
      m_report.worst = std::max(m_report.worst, worst.error);
      return;
    }
    fail(seed, worst.what);
    writeFailure(m_options.failures, seed, text,
                 worst.what + "\n" + fp::emitGlsl(program, {}, m_options.numerics).text,
                 seen[0].rgba, picture);
  }

  Backend &m_backend;
  const SuiteOptions &m_options;
  FloatTarget m_target;
  Report m_report;
  std::map<Optioned, std::vector<float>> m_measured;
};
} // namespace

bool begin(Report &report, FloatTarget &target) {
  report.renderer = reinterpret_cast<const char *>(glGetString(GL_RENDERER));
  if (target.create())
    return true;
  report.failures.push_back({0, "no float framebuffer on this host"});
  return false;
}

Report runSuite(Backend &backend, const SuiteOptions &options) {
  return Suite(backend, options).run();
}

} // namespace arbiter::differential
