#include "fp_compiler/testing/inputs.h"

#include <bit>
#include <cmath>
#include <string_view>

#include "fp_compiler/ir/print.h"
#include "fp_compiler/testing/random.h"
#include "util/hash.h"

namespace arbiter::fp::testing {

namespace {
/// Four numbers in [-2,2) that a text and a pixel determine.
ir::Vec4 madeUp(std::string_view text, std::uint64_t pixel) {
  Random random(arbiter::hashBytes(text).low ^ (pixel * 0x9E3779B97F4A7C15u));
  return {random.real(-2, 2), random.real(-2, 2), random.real(-2, 2), random.real(-2, 2)};
}

bool sameBits(float a, float b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

bool sameBits(const ir::Vec4 &a, const ir::Vec4 &b) {
  for (std::size_t i = 0; i < 4; ++i)
    if (!sameBits(a[i], b[i]))
      return false;
  return true;
}
} // namespace

Outcome outcome(const ir::Program &program, std::uint64_t pixel) {
  std::vector<ir::Vec4> attributes;
  for (const ir::Attribute &attribute : program.attributes)
    attributes.push_back(madeUp(ir::bindingText(attribute), pixel));
  ir::Inputs inputs;
  inputs.attributes = attributes;
  inputs.fogCoordinate = madeUp("fog", pixel)[0];
  inputs.parameter = [](const ir::Parameter &p) { return madeUp(ir::bindingText(p), 0); };
  inputs.texture = [](const ir::Sample &s) {
    // Any function of the request will do, as long as it is bounded.
    const float mix = s.coordinate[0] + 3 * s.coordinate[1] + 7 * s.coordinate[2] + 11 * s.bias +
                      float(s.unit) + 5 * float(int(s.target));
    const float wave = std::isfinite(mix) ? std::sin(mix) : 0.0f;
    return ir::Vec4{wave, wave * wave, -wave, 1 - wave};
  };
  const ir::Evaluation evaluation = ir::evaluate(program, inputs);
  Outcome result;
  result.killed = evaluation.killed;
  result.depth = evaluation.depth;
  for (std::size_t i = 0; i < program.outputs.size(); ++i)
    if (program.outputs[i].kind == ir::OutputKind::Color)
      result.colors[program.outputs[i].index] = evaluation.outputs[i];
  return result;
}

bool same(const Outcome &a, const Outcome &b) {
  if (a.killed != b.killed || a.depth.has_value() != b.depth.has_value())
    return false;
  if (a.depth && !sameBits(*a.depth, *b.depth))
    return false;
  for (std::size_t i = 0; i < a.colors.size(); ++i) {
    if (a.colors[i].has_value() != b.colors[i].has_value())
      return false;
    if (a.colors[i] && !sameBits(*a.colors[i], *b.colors[i]))
      return false;
  }
  return true;
}

} // namespace arbiter::fp::testing
