#include "fp_compiler/testing/inputs.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/specials.h"
#include "util/hash.h"

namespace arbiter::fp::testing {

namespace {
/// Returns four numbers in [-2,2), or special values, that depend only on the text and the pixel.
ir::Vec4 madeUp(std::string_view text, std::uint64_t pixel, bool special) {
  Random random(arbiter::hashBytes(text).low ^ (pixel * 0x9E3779B97F4A7C15u));
  ir::Vec4 value = {};
  for (float &component : value)
    component = random.real(-2, 2);
  for (float &component : value)
    if (special && random.chance(25))
      component = kSpecials[std::size_t(random.below(int(kSpecials.size())))];
  return value;
}

/// Returns the binding's name. Attribute 0 of a vertex is its position.
std::string nameOf(const ir::Attribute &attribute, ir::Language language) {
  const bool position = attribute.kind == ir::AttributeKind::Generic && attribute.index == 0;
  return ir::bindingText(position ? ir::Attribute{ir::AttributeKind::Position, 0} : attribute,
                         language);
}

/// Returns the components of an output that some instruction writes.
std::uint8_t written(const ir::Program &program, std::size_t output) {
  std::uint8_t mask = 0;
  for (const ir::Instruction &instruction : program.code)
    if (instruction.dst.file == ir::File::Output && instruction.dst.index == output)
      mask |= ir::writeMask(instruction);
  return mask;
}
/// Returns a made-up texel. Any bounded function of the request will do.
ir::Vec4 texel(const ir::Sample &s) {
  const float mix = s.coordinate[0] + 3 * s.coordinate[1] + 7 * s.coordinate[2] + 11 * s.bias +
                    float(s.unit) + 5 * float(int(s.target));
  const float wave = std::isfinite(mix) ? std::sin(mix) : 0.0f;
  return {wave, wave * wave, -wave, 1 - wave};
}

std::vector<ir::Vec4> attributesOf(const ir::Program &program, const Made &made) {
  std::vector<ir::Vec4> attributes;
  for (const ir::Attribute &attribute : program.attributes)
    attributes.push_back(madeUp(nameOf(attribute, program.language), made.pixel, made.special));
  return attributes;
}

ir::Inputs inputsOf(const Made &made, const std::vector<ir::Vec4> &attributes) {
  ir::Inputs inputs;
  inputs.attributes = attributes;
  inputs.fogCoordinate = madeUp("fog", made.pixel, made.special)[0];
  inputs.numerics = made.numerics;
  inputs.parameter = [special = made.special](const ir::Parameter &p) {
    return madeUp(ir::bindingText(p), 0, special);
  };
  inputs.texture = texel;
  inputs.observer = made.observer;
  return inputs;
}

Outcome outcomeOf(const ir::Program &program, const ir::Evaluation &evaluation) {
  Outcome result;
  result.killed = evaluation.killed;
  result.depth = evaluation.depth;
  const bool vertex = program.language == ir::Language::ArbVertex;
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    const ir::Output &output = program.outputs[i];
    const std::uint8_t mask = ir::resultMask(output.kind);
    if (output.kind == ir::OutputKind::Depth || (vertex && (written(program, i) & mask) == 0))
      continue;
    ir::Vec4 value = evaluation.outputs[i];
    for (std::size_t c = 0; c < 4; ++c)
      if (!(mask >> c & 1))
        value[c] = 0;
    result.results[{output.kind, output.index}] = value;
  }
  return result;
}
} // namespace

Outcome outcome(const ir::Program &program, const Made &made) {
  const std::vector<ir::Vec4> attributes = attributesOf(program, made);
  return outcomeOf(program, ir::evaluate(program, inputsOf(made, attributes)));
}

std::array<Outcome, 4> quadOutcome(const ir::Program &program, const Made &made) {
  std::array<std::vector<ir::Vec4>, 4> attributes;
  std::array<ir::Inputs, 4> inputs;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    Made one = made;
    one.pixel += lane;
    attributes[lane] = attributesOf(program, one);
    inputs[lane] = inputsOf(one, attributes[lane]);
  }
  const std::array<ir::Evaluation, 4> evaluations = ir::evaluateQuad(program, inputs);
  std::array<Outcome, 4> outcomes;
  for (std::size_t lane = 0; lane < 4; ++lane)
    outcomes[lane] = outcomeOf(program, evaluations[lane]);
  return outcomes;
}

bool same(const Outcome &a, const Outcome &b) {
  if (a.killed != b.killed || a.depth.has_value() != b.depth.has_value())
    return false;
  if (a.depth && !sameBits(*a.depth, *b.depth))
    return false;
  return std::equal(a.results.begin(), a.results.end(), b.results.begin(), b.results.end(),
                    [](const auto &one, const auto &other) {
                      return one.first == other.first && sameBits(one.second, other.second);
                    });
}

} // namespace arbiter::fp::testing
