#include "expectation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fp_compiler/testing/random.h"

namespace arbiter::r300 {

using namespace fp::ir;

namespace {
constexpr int kTrials = 16;
constexpr float kUlp = 0x1p-23f;
/// If results spread wider than this, relative to 1 + |result|, a value is not judged.
constexpr float kIllConditioned = 0.02f;

struct Tolerance {
  float operand = 0, relative = 0, absolute = 0;
};

Tolerance tolerance(Opcode op) {
  switch (op) {
  case Opcode::Cos:
  case Opcode::Sin:
  case Opcode::Scs: // two parabolas, the second of the first: error at most 0.0011
    return {kUlp, 0, 1.5e-3f};
  case Opcode::Pow:
  case Opcode::Lit:
    return {kUlp, 0x1p-15f, 0x1p-20f};
  case Opcode::Lg2:
    return {kUlp, kUlp, kUlp};
  case Opcode::Flr: // a - FRC(a)
    return {0, kUlp, kUlp};
  case Opcode::Abs:
  case Opcode::Cmp:
  case Opcode::Max:
  case Opcode::Min:
  case Opcode::Mov:
  case Opcode::Swz:
    return {};
  default:
    return {kUlp, 2 * kUlp, 0};
  }
}

/// Moves values up or down by their tolerance.
class Shaker {
public:
  Shaker(const Program &program, const Inputs &inputs, std::uint64_t seed)
      : m_attributes(inputs.attributes.begin(), inputs.attributes.end()), m_random(seed),
        m_inputs(inputs) {
    m_inputs.operands = [this](const Instruction &instruction, Operands &operands) {
      for (Vec4 &operand : operands)
        for (float &value : operand)
          shake(value, tolerance(instruction.op).operand, 0);
      if (instruction.op == Opcode::Lit)
        leaveOpen(operands[0][1], operands[0][3]);
      if (instruction.op == Opcode::Pow)
        leaveOpen(operands[0][0], operands[1][0]);
    };
    m_inputs.result = [this](const Instruction &instruction, Vec4 &value) {
      const Tolerance allowed = tolerance(instruction.op);
      for (float &component : value)
        // Otherwise a zero follows from a rule, not from rounding
        if (component != 0 || allowed.absolute != 0)
          shake(component, allowed.relative, allowed.absolute);
    };
    m_inputs.texture = [this, texture = inputs.texture](const Sample &sample) {
      Sample moved = sample;
      for (float &coordinate : moved.coordinate)
        shake(coordinate, 4 * kUlp, 0);
      return texture(moved);
    };
    m_exact = m_attributes;
    for (std::size_t i = 0; i < m_exact.size(); ++i)
      m_position.push_back(program.attributes[i].kind == AttributeKind::Position);
  }

  /// Returns moved inputs, valid until the next call. The window position is moved through the clip
  /// position.
  const Inputs &next() {
    ++m_run;
    m_attributes = m_exact;
    for (std::size_t i = 0; i < m_attributes.size(); ++i)
      for (float &value : m_attributes[i])
        if (m_position[i])
          shake(value, 4 * kUlp, 16 * kUlp);
    m_inputs.attributes = m_attributes;
    return m_inputs;
  }

private:
  void shake(float &value, float relative, float absolute) {
    if (relative == 0 && absolute == 0)
      return;
    // Every other run uses the extremes, as a clamp may hide everything else.
    const float share =
        m_run % 2 ? (m_random.chance(50) ? 1.0f : -1.0f) : m_random.real(-1.0f, 1.0f);
    value += share * (relative * std::fabs(value) + absolute);
  }

  /// Avoids a base that is not positive with a negative exponent. ir/semantics.h gives 0, LG2 and
  /// EX2 give an infinity, and the specification does not define it.
  static void leaveOpen(float &base, float exponent) {
    if (base <= 0 && exponent < 0)
      base = std::numeric_limits<float>::min();
  }

  std::vector<Vec4> m_attributes, m_exact;
  int m_run = 0;
  std::vector<bool> m_position;
  fp::testing::Random m_random;
  Inputs m_inputs;
};

void widen(Expected &expected, float seen) {
  if (!std::isfinite(expected.value) || !std::isfinite(seen))
    expected.comparable = false;
  else
    expected.slack = std::max(expected.slack, std::fabs(seen - expected.value));
}

void finishTolerance(Expected &expected) {
  const float scale = 1.0f + std::fabs(expected.value);
  if (expected.slack > kIllConditioned * scale)
    expected.comparable = false;
  // The trials are unlikely to include the worst directions.
  expected.slack = 4.0f * expected.slack + 1e-6f * scale;
}

/// True if an output is a color; depth is only in Evaluation::depth.
bool isColor(const Program &program, std::size_t output) {
  return program.outputs[output].kind == OutputKind::Color;
}

void compare(Verdict &verdict, const Expected &expected, float seen, const std::string &where) {
  if (!expected.comparable) {
    ++verdict.skipped;
    return;
  }
  ++verdict.compared;
  const float error = std::isfinite(seen) ? std::fabs(seen - expected.value) / expected.slack
                                          : std::numeric_limits<float>::infinity();
  if (error <= verdict.error)
    return;
  verdict.error = error;
  verdict.what = where + ": " + std::to_string(seen) + ", expected " +
                 std::to_string(expected.value) + " +- " + std::to_string(expected.slack);
}
} // namespace

Expectation expect(const Program &program, const Inputs &inputs, std::uint64_t seed) {
  Expectation result;
  const Evaluation exact = evaluate(program, inputs);
  result.killed = exact.killed;
  result.outputs.resize(exact.outputs.size());
  for (std::size_t o = 0; o < exact.outputs.size(); ++o)
    for (std::size_t i = 0; i < 4; ++i)
      result.outputs[o][i].value = exact.outputs[o][i];
  if (exact.depth)
    result.depth = Expected{*exact.depth, 0, true};
  Shaker shaker(program, inputs, seed);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Evaluation seen = evaluate(program, shaker.next());
    if (seen.killed != exact.killed) {
      result.comparable = false;
      return result;
    }
    for (std::size_t o = 0; o < seen.outputs.size(); ++o)
      for (std::size_t i = 0; i < 4; ++i)
        widen(result.outputs[o][i], seen.outputs[o][i]);
    if (result.depth && seen.depth)
      widen(*result.depth, *seen.depth);
  }
  for (auto &output : result.outputs)
    for (Expected &expected : output)
      finishTolerance(expected);
  if (result.depth)
    finishTolerance(*result.depth);
  return result;
}

Verdict judge(const Program &program, const Expectation &expected, const Evaluation &seen) {
  Verdict verdict;
  if (!expected.comparable) {
    verdict.skipped = 1;
    return verdict;
  }
  if (seen.killed != expected.killed) {
    verdict.error = std::numeric_limits<float>::infinity();
    verdict.what = expected.killed ? "drawn, expected killed" : "killed, expected drawn";
    return verdict;
  }
  if (expected.killed) {
    verdict.compared = 1;
    return verdict;
  }
  for (std::size_t o = 0; o < expected.outputs.size(); ++o)
    for (std::size_t i = 0; i < 4 && isColor(program, o); ++i)
      compare(verdict, expected.outputs[o][i], seen.outputs[o][i],
              "color[" + std::to_string(program.outputs[o].index) + "]." + "xyzw"[i]);
  if (expected.depth.has_value() != seen.depth.has_value()) {
    verdict.error = std::numeric_limits<float>::infinity();
    verdict.what = expected.depth ? "no depth is written" : "a depth is written";
  } else if (expected.depth) {
    compare(verdict, *expected.depth, *seen.depth, "depth");
  }
  return verdict;
}

} // namespace arbiter::r300
