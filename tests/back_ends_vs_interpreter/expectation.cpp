#include "expectation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fp_compiler/testing/random.h"
#include "tolerance.h"

namespace arbiter::differential {

using namespace fp::ir;

namespace {
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Inputs inputsOf(const PixelInputs &pixel) {
  Inputs inputs;
  inputs.attributes = pixel.attributes;
  inputs.fogCoordinate = pixel.fogCoordinate;
  inputs.secondary = pixel.secondary;
  inputs.parameter = parameterValue;
  inputs.texture = sampleTexture;
  inputs.numerics = pixel.numerics;
  return inputs;
}

/// True if the host computes the state from what it was given: an error in the last bit may
/// truncate it to another 24-bit float.
bool isComputed(const Parameter &parameter) {
  if (parameter.kind != ParameterKind::State)
    return false;
  const StateRef &state = parameter.state;
  return state.item == StateItem::LightSpotDirection || state.item == StateItem::LightHalf ||
         state.item == StateItem::FogParams || state.modifier == MatrixModifier::Inverse ||
         state.modifier == MatrixModifier::InvTrans;
}

bool unpacks(Opcode op) {
  return op == Opcode::Up2h || op == Opcode::Up2us || op == Opcode::Up4b || op == Opcode::Up4ub;
}

/// Moves values up or down by their tolerance.
class Shaker {
public:
  explicit Shaker(std::uint64_t seed) : m_random(seed) {}

  void shake(float &value, float relative, float absolute) {
    value += m_random.real(-1.0f, 1.0f) * (relative * std::fabs(value) + absolute);
  }

  /// Returns moved inputs.
  /// \param nv a program with NVIDIA's options. Its registers may hold bits from PK*, and its flow
  /// is sums and products of flags, which any host computes exactly. A flag that is nearly off
  /// would be on.
  Inputs inputs(const PixelInputs &pixel, bool nv) {
    Inputs result = inputsOf(pixel);
    m_nv = nv;
    const fp::Numerics numerics = pixel.numerics;
    result.parameter = [this](const Parameter &parameter) {
      Vec4 value = parameterValue(parameter);
      if (isComputed(parameter))
        for (float &component : value)
          shake(component, 0x1p-23f, 0);
      return value;
    };
    result.operands = [this, numerics](const Instruction &instruction, Operands &operands) {
      const Tolerance allowed = tolerance(instruction.op, numerics);
      if (allowed.operand != 0)
        for (Vec4 &operand : operands)
          for (float &value : operand)
            if (!isExact(instruction.op, value))
              shake(value, allowed.operand, 0);
    };
    result.result = [this, numerics, nv](const Instruction &instruction, Vec4 &value) {
      if (nv && carriesBits(instruction.op) && !unpacks(instruction.op))
        return;
      const Tolerance allowed = tolerance(instruction.op, numerics);
      // GLSL need not preserve NaNs: hosts compute x - x as 0 for any x.
      for (float &component : value)
        if (std::isnan(component) && m_random.chance(50))
          component = 0;
      if (allowed.relative != 0 || allowed.absolute != 0)
        for (float &component : value)
          // Such a zero follows from a rule, not from rounding.
          if (component != 0 && !isExact(instruction.op, component)) {
            shake(component, allowed.relative, allowed.absolute);
            component = held(component, numerics);
          }
    };
    result.texture = [this, numerics](const Sample &sample) {
      Sample moved = sample;
      const float edge = tolerance(Opcode::Tex, numerics).operand;
      for (std::size_t i = 0; i < 3; ++i)
        shake(moved.coordinate[i], edge, edge);
      return sampleTexture(moved);
    };
    return result;
  }

private:
  [[nodiscard]] bool isExact(Opcode op, float value) const {
    return m_nv && sumsProducts(op) && std::fabs(value) <= 64 && value == std::nearbyint(value);
  }

  fp::testing::Random m_random;
  bool m_nv = false;
};

bool alike(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void widen(Expected &expected, float seen) {
  if (alike(expected.value, seen))
    return;
  if (!std::isfinite(expected.value) || !std::isfinite(seen))
    expected.comparable = false;
  else
    expected.slack = std::max(expected.slack, std::fabs(seen - expected.value));
}

/// Returns the tolerance of the last step to a pixel. R300 results are stored unchanged, except
/// after a fog with the host's own exp2().
float pixelTolerance(const Program &program, fp::Numerics numerics) {
  if (numericsOf(program.language, numerics) != fp::Numerics::Fp24)
    return kPixelTolerance;
  return program.options.fog == FogMode::None ? 0.0f : 0x1p-14f;
}

void finishTolerance(Expected &expected, float last) {
  if (!std::isfinite(expected.value))
    return;
  const float scale = 1.0f + std::fabs(expected.value);
  if (expected.slack > kIllConditioned * scale)
    expected.comparable = false;
  // The trials are unlikely to include the worst directions.
  expected.slack = 4.0f * expected.slack + last * scale;
}

template <typename F>
void eachColor(const Program &program, const Evaluation &evaluation, F visit) {
  for (std::size_t o = 0; o < program.outputs.size(); ++o)
    if (program.outputs[o].kind == OutputKind::Color && program.outputs[o].index < kColorBuffers)
      visit(program.outputs[o].index, evaluation.outputs[o]);
}
} // namespace

namespace {
template <std::size_t N>
std::array<Evaluation, N> evaluateAll(const Program &program, const std::array<Inputs, N> &inputs) {
  if constexpr (N == 4)
    return evaluateQuad(program, inputs);
  else
    return {evaluate(program, inputs[0])};
}

ExpectedPixel begin(const Program &program, const Evaluation &exact) {
  ExpectedPixel result;
  result.killed = exact.killed;
  eachColor(program, exact, [&](std::size_t buffer, const Vec4 &value) {
    for (std::size_t i = 0; i < 4; ++i)
      result.colors[buffer][i].value = value[i];
  });
  if (exact.depth)
    result.depth = Expected{std::clamp(*exact.depth, 0.0f, 1.0f), 0, true};
  return result;
}

void addTrial(const Program &program, const Evaluation &seen, ExpectedPixel &result) {
  if (seen.killed != result.killed)
    result.comparable = false;
  if (!result.comparable)
    return;
  eachColor(program, seen, [&](std::size_t buffer, const Vec4 &value) {
    for (std::size_t i = 0; i < 4; ++i)
      widen(result.colors[buffer][i], value[i]);
  });
  if (result.depth && seen.depth)
    widen(*result.depth, std::clamp(*seen.depth, 0.0f, 1.0f));
}

void finish(ExpectedPixel &result, float last) {
  for (auto &color : result.colors)
    for (Expected &expected : color)
      finishTolerance(expected, last);
  if (result.depth)
    finishTolerance(*result.depth, last);
}

template <std::size_t N>
std::array<ExpectedPixel, N> expectAll(const Program &program,
                                       const std::array<PixelInputs, N> &pixels, std::uint64_t seed,
                                       int trials) {
  Shaker shaker(seed);
  std::array<Inputs, N> exact, shaken;
  for (std::size_t i = 0; i < N; ++i) {
    exact[i] = inputsOf(pixels[i]);
    shaken[i] = shaker.inputs(pixels[i], program.options.nv != NvOption::None);
  }
  const std::array<Evaluation, N> first = evaluateAll(program, exact);
  std::array<ExpectedPixel, N> results;
  for (std::size_t i = 0; i < N; ++i)
    results[i] = begin(program, first[i]);
  const auto says = [](const ExpectedPixel &pixel) { return pixel.comparable; };
  for (int trial = 0; trial < trials && std::any_of(results.begin(), results.end(), says);
       ++trial) {
    const std::array<Evaluation, N> seen = evaluateAll(program, shaken);
    for (std::size_t i = 0; i < N; ++i)
      addTrial(program, seen[i], results[i]);
  }
  for (ExpectedPixel &result : results)
    if (result.comparable)
      finish(result, pixelTolerance(program, pixels[0].numerics));
  return results;
}
} // namespace

ExpectedPixel expect(const Program &program, const PixelInputs &inputs, std::uint64_t seed,
                     int trials) {
  return expectAll<1>(program, {inputs}, seed, trials)[0];
}

std::array<ExpectedPixel, 4> expect(const Program &program,
                                    const std::array<PixelInputs, 4> &inputs, std::uint64_t seed,
                                    int trials) {
  return expectAll(program, inputs, seed, trials);
}

bool needsQuads(const Program &program) {
  return std::any_of(program.code.begin(), program.code.end(), [](const Instruction &instruction) {
    return instruction.op == Opcode::Ddx || instruction.op == Opcode::Ddy;
  });
}

namespace {
void compare(Verdict &verdict, const Expected &expected, float seen, const std::string &where) {
  if (!expected.comparable) {
    ++verdict.skipped;
    return;
  }
  ++verdict.compared;
  if (alike(expected.value, seen))
    return;
  const float error = std::isfinite(expected.value) && std::isfinite(seen)
                          ? std::fabs(seen - expected.value) / expected.slack
                          : kInfinity;
  if (error <= verdict.error)
    return;
  verdict.error = error;
  verdict.what = where + ": " + std::to_string(seen) + ", expected " +
                 std::to_string(expected.value) + " +- " + std::to_string(expected.slack);
}
} // namespace

Verdict judge(const Program &program, const ExpectedPixel &expected,
              const std::array<Vec4, kColorBuffers> &colors, float depth) {
  Verdict verdict;
  if (!expected.comparable) {
    verdict.skipped = 4;
    return verdict;
  }
  const bool untouched = colors[0] == Vec4{kUntouched, kUntouched, kUntouched, kUntouched};
  if (untouched != expected.killed) {
    verdict.error = kInfinity;
    verdict.compared = 4;
    verdict.what = expected.killed ? "drawn, expected killed" : "killed, expected drawn";
    return verdict;
  }
  if (expected.killed) {
    verdict.compared = 4;
    return verdict;
  }
  for (const Output &output : program.outputs) {
    if (output.kind == OutputKind::Depth) {
      if (expected.depth)
        compare(verdict, *expected.depth, depth, "depth");
      continue;
    }
    for (std::size_t i = 0; output.index < kColorBuffers && i < 4; ++i)
      compare(verdict, expected.colors[output.index][i], colors[output.index][i],
              "color[" + std::to_string(output.index) + "]." + "xyzw"[i]);
  }
  return verdict;
}

} // namespace arbiter::differential
