#include "apps/tools/advise/trial.h"

#include <algorithm>
#include <cmath>

#include "apps/tools/ir_names.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/ir/semantics.h"

namespace arbiter::tools::advise {

namespace {

using fp::ir::Attribute;

struct Range {
  float lo, hi;
};

/// Returns a pseudorandom number for a key (the finalizer of SplitMix64).
std::uint64_t mixed(std::uint64_t key) {
  key += 0x9E3779B97F4A7C15u;
  key = (key ^ key >> 30) * 0xBF58476D1CE4E5B9u;
  key = (key ^ key >> 27) * 0x94D049BB133111EBu;
  return key ^ key >> 31;
}

/// Returns a number in the range. Half of them are on a grid, so that equal numbers occur. The
/// other half use all bits of a float's fraction, so that sums round.
float valueIn(Range range, std::uint64_t key) {
  constexpr float kSpecials[] = {0.0f, 0.5f, 1.0f, 2.0f, -1.0f};
  const std::uint64_t bits = mixed(key);
  if (bits % 8 == 0) {
    const float special = kSpecials[(bits >> 8) % std::size(kSpecials)];
    if (special >= range.lo && special <= range.hi)
      return special;
  }
  const float part = (bits >> 15 & 1) != 0 ? float((bits >> 16) % 257) / 256.0f
                                           : float(bits >> 40) / float(1 << 24);
  return range.lo + (range.hi - range.lo) * part;
}

Range rangeOf(const Attribute &attribute, fp::ir::Language language, int component) {
  if (language == fp::ir::Language::ArbVertex)
    return {-2.0f, 2.0f};
  switch (attribute.kind) {
  case AttributeKind::TexCoord:
    return component == 3 ? Range{0.5f, 2.0f} : Range{-1.5f, 2.5f};
  case AttributeKind::Position:
    return component < 2 ? Range{0.0f, 1024.0f} : Range{0.0f, 1.0f};
  case AttributeKind::FogCoord:
    return component == 0   ? Range{0.0f, 16.0f}
           : component == 3 ? Range{1.0f, 1.0f}
                            : Range{0.0f, 0.0f};
  default:
    return {0.0f, 1.0f};
  }
}

std::uint64_t keyOf(const Attribute &attribute) {
  // vertex.attrib[n] can alias conventional attributes, but is treated as a separate array.
  return 1 + (std::uint64_t(attribute.kind) << 8 | std::uint64_t(attribute.index) << 16);
}

std::uint64_t keyOf(const fp::ir::Parameter &parameter) {
  const fp::ir::StateRef &state = parameter.state;
  return 2 + (std::uint64_t(parameter.kind) << 8 | std::uint64_t(parameter.index) << 12 |
              std::uint64_t(state.item) << 28 | std::uint64_t(state.back) << 34 |
              std::uint64_t(state.index) << 35 | std::uint64_t(state.modifier) << 43 |
              std::uint64_t(state.row) << 46);
}

/// The generated inputs of one number.
class Trial {
public:
  explicit Trial(std::uint64_t number) : m_seed(mixed(number)) {}

  [[nodiscard]] Vec4 of(const Attribute &attribute, fp::ir::Language language) const {
    Vec4 value;
    for (int c = 0; c < 4; ++c)
      value[std::size_t(c)] =
          valueIn(rangeOf(attribute, language, c), key(keyOf(attribute), std::uint64_t(c)));
    return value;
  }
  [[nodiscard]] Vec4 of(const fp::ir::Parameter &parameter) const {
    Vec4 value;
    for (std::uint64_t c = 0; c < 4; ++c)
      value[c] = valueIn({-2.0f, 2.0f}, key(keyOf(parameter), c));
    return value;
  }
  /// Returns a texel that is often exactly 0 or 1, so that comparisons find equal numbers.
  [[nodiscard]] Vec4 of(const fp::ir::Sample &sample) const {
    const std::uint64_t unit = std::uint64_t(sample.unit) << 8 | std::uint64_t(sample.target) << 16;
    Vec4 texel;
    for (std::uint64_t c = 0; c < 4; ++c) {
      float phase = valueIn({0.0f, 6.25f}, key(3 + unit, c)) + sample.bias;
      for (std::uint64_t i = 0; i < 3; ++i)
        phase += sample.coordinate[i] * valueIn({0.5f, 2.5f}, key(4 + unit, c * 3 + i));
      const float wave = std::isfinite(phase) ? std::sin(phase) : 0.0f;
      texel[c] = std::clamp(0.5f + 0.625f * wave, 0.0f, 1.0f);
    }
    return texel;
  }

private:
  [[nodiscard]] std::uint64_t key(std::uint64_t what, std::uint64_t component) const {
    return m_seed ^ mixed(what * 16 + component);
  }

  std::uint64_t m_seed;
};

/// An additional input of the rewritten program, with its value.
struct Given {
  Derived derived;
  Vec4 value = {};
};

class Runner {
public:
  Runner(const Program &program, const Trial &trial) : m_program(program), m_trial(trial) {
    for (const Attribute &attribute : program.attributes)
      m_attributes.push_back(trial.of(attribute, program.language));
    m_inputs.parameter = [this](const fp::ir::Parameter &parameter) {
      return parameterOf(parameter);
    };
    m_inputs.texture = [this](const fp::ir::Sample &sample) { return texelOf(sample); };
    m_inputs.fogCoordinate = trial.of(Attribute{AttributeKind::FogCoord, 0}, program.language)[0];
  }

  /// Runs the program and records the register values that become the other program's inputs.
  fp::ir::Evaluation run(std::vector<Given> &given) {
    for (Given &each : given)
      if (each.derived.operand != Derived::kResult)
        each.value = operandOf(m_program.code[each.derived.instruction], each.derived.operand);
    m_inputs.result = [this, &given](const fp::ir::Instruction &instruction, Vec4 &value) {
      const auto index = std::uint32_t(&instruction - m_program.code.data());
      for (Given &each : given)
        if (each.derived.instruction == index && each.derived.operand == Derived::kResult)
          for (std::size_t c = 0; c < 4; ++c)
            each.value[c] =
                instruction.dst.saturate ? fp::ir::saturated(value[c]) : fp::ir::flushed(value[c]);
    };
    return evaluate();
  }
  fp::ir::Evaluation runGiven(const std::vector<Given> &given) {
    m_given = &given;
    for (const Given &each : given)
      for (std::size_t i = 0; i < m_program.attributes.size(); ++i)
        if (each.derived.kind == Derived::Kind::TexCoord &&
            m_program.attributes[i] == Attribute{AttributeKind::TexCoord, each.derived.index})
          m_attributes[i] = each.value;
    return evaluate();
  }

private:
  fp::ir::Evaluation evaluate() {
    m_inputs.attributes = m_attributes;
    return fp::ir::evaluate(m_program, m_inputs);
  }

  [[nodiscard]] Vec4 parameterOf(const fp::ir::Parameter &parameter) const {
    if (m_given != nullptr)
      for (const Given &each : *m_given)
        if (each.derived.kind == Derived::Kind::Local &&
            parameter.kind == fp::ir::ParameterKind::Local && parameter.index == each.derived.index)
          return each.value;
    return m_trial.of(parameter);
  }

  [[nodiscard]] Vec4 texelOf(const fp::ir::Sample &sample) const {
    if (m_given != nullptr)
      for (const Given &each : *m_given)
        if (each.derived.kind == Derived::Kind::Texture && sample.unit == each.derived.index)
          return each.value;
    return m_trial.of(sample);
  }

  /// Returns the value of an operand that is an attribute or a parameter.
  [[nodiscard]] Vec4 operandOf(const fp::ir::Instruction &instruction, int number) const {
    const fp::ir::Operand &operand = instruction.src[std::size_t(number)];
    const Vec4 source = operand.file == fp::ir::File::Attribute
                            ? m_attributes[operand.index]
                            : parameterOf(m_program.parameters[operand.index]);
    Vec4 value = {};
    for (std::size_t c = 0; c < 4; ++c)
      if (operand.swizzle[c] <= fp::ir::Select::W)
        value[c] = source[std::size_t(operand.swizzle[c])] * (operand.negate >> c & 1 ? -1.f : 1.f);
    return value;
  }

  const Program &m_program;
  const Trial &m_trial;
  std::vector<Vec4> m_attributes;
  fp::ir::Inputs m_inputs;
  const std::vector<Given> *m_given = nullptr;
};

bool nearAt(const Vec4 &a, const Vec4 &b, std::uint8_t mask, Nearness nearness) {
  for (std::size_t c = 0; c < 4; ++c)
    if ((mask >> c & 1) && !near(a[c], b[c], nearness))
      return false;
  return true;
}

/// Compares outputs by their bindings, because the programs' tables may differ.
bool sameResults(const Program &a, const fp::ir::Evaluation &x, const Program &b,
                 const fp::ir::Evaluation &y, Nearness nearness) {
  if (x.killed != y.killed || x.depth.has_value() != y.depth.has_value())
    return false;
  if (x.depth && !near(*x.depth, *y.depth, nearness))
    return false;
  if (a.outputs.size() != b.outputs.size())
    return false;
  for (std::size_t i = 0; i < a.outputs.size(); ++i) {
    const auto other = std::find(b.outputs.begin(), b.outputs.end(), a.outputs[i]);
    if (other == b.outputs.end())
      return false;
    const fp::ir::OutputKind kind = a.outputs[i].kind;
    if (kind != fp::ir::OutputKind::Depth &&
        !nearAt(x.outputs[i], y.outputs[std::size_t(other - b.outputs.begin())],
                fp::ir::resultMask(kind), nearness))
      return false;
  }
  return true;
}

} // namespace

bool near(float a, float b, Nearness nearness) {
  if (a == b || (std::isnan(a) && std::isnan(b)))
    return true;
  if (nearness == Nearness::Exact || !std::isfinite(a) || !std::isfinite(b))
    return false;
  return std::fabs(a - b) <= 0x1p-14f * std::max({1.0f, std::fabs(a), std::fabs(b)});
}

bool equal(const Program &original, const Program &rewritten, const std::vector<Derived> &derived,
           Nearness nearness, std::uint64_t first, std::uint32_t count) {
  std::vector<Given> given;
  given.reserve(derived.size());
  for (const Derived &each : derived)
    given.push_back({each, {}});
  // A discarded fragment shows no result, so that further inputs are tested in its place.
  constexpr std::uint32_t kMaxDiscarded = 8, kLeastSeen = 16;
  std::uint32_t seen = 0;
  for (std::uint32_t i = 0; i < count * kMaxDiscarded && seen < count; ++i) {
    const Trial trial(first + i);
    const fp::ir::Evaluation expected = Runner(original, trial).run(given);
    const fp::ir::Evaluation got = Runner(rewritten, trial).runGiven(given);
    if (!sameResults(original, expected, rewritten, got, nearness))
      return false;
    seen += expected.killed ? 0 : 1;
  }
  return seen >= std::min(count, kLeastSeen);
}

} // namespace arbiter::tools::advise
