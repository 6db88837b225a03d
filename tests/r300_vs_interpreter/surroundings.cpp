#include "surroundings.h"

#include <cmath>
#include <string>

#include "fp_compiler/hw/r300/check/reads.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/testing/interval.h"
#include "fp_compiler/testing/random.h"
#include "util/hash.h"

namespace arbiter::r300 {

using namespace fp::ir;

namespace {
fp::testing::Random randomOf(const std::string &name, std::uint64_t fragment) {
  return fp::testing::Random(hashBytes(name).low ^ (fragment * 0x9E3779B97F4A7C15u));
}

Vec4 attributeValue(const Attribute &attribute, std::uint64_t fragment) {
  fp::testing::Random random = randomOf(bindingText(attribute), fragment);
  Vec4 value;
  for (std::size_t i = 0; i < 4; ++i) {
    const fp::testing::Interval range = fp::testing::attributeRange(attribute.kind, int(i));
    value[i] = random.real(range.lo, range.hi);
  }
  if (attribute.kind == AttributeKind::FogCoord)
    return {value[0], 0, 0, 1};
  if (attribute.kind == AttributeKind::Position)
    value[3] = 0.25f + 0.75f * value[3]; // 1/w of a visible fragment
  return value;
}

Vec4 parameterValue(const Parameter &parameter) {
  const auto isState = [&](StateItem item) {
    return parameter.kind == ParameterKind::State && parameter.state.item == item;
  };
  if (isState(StateItem::FogParams)) // density, start, end, 1/(end-start)
    return {0.75f, 0.25f, 1.75f, 1 / 1.5f};
  fp::testing::Random random = randomOf(bindingText(parameter), 0);
  Vec4 value;
  for (float &component : value)
    component = isState(StateItem::FogColor) ? random.real(0, 1) : random.real(-2, 2);
  return value;
}
} // namespace

Vec4 sampleTexture(const Sample &sample) {
  if (isShadow(sample.target)) {
    Sample depth = sample;
    depth.target = fp::hw::r300::sampledTarget(sample.target);
    depth.coordinate[2] = 0;
    const float passes = sample.coordinate[2] <= sampleTexture(depth)[0] ? 1.0f : 0.0f;
    return {passes, passes, passes, passes};
  }
  // Any smooth function of all inputs serves.
  const float place = sample.coordinate[0] + 1.7f * sample.coordinate[1] +
                      2.3f * sample.coordinate[2] + 0.7f * sample.bias + 5.0f * float(sample.unit) +
                      11.0f * float(int(sample.target));
  if (!std::isfinite(place))
    return {};
  Vec4 texel;
  for (std::size_t i = 0; i < 4; ++i)
    texel[i] = 0.5f + 0.5f * std::sin(place + float(i));
  return texel;
}

Surroundings::Surroundings(const Program &program, std::uint64_t fragment) {
  for (const Attribute &attribute : program.attributes)
    m_attributes.push_back(attributeValue(attribute, fragment));
  m_inputs.attributes = m_attributes;
  m_inputs.fogCoordinate = attributeValue({AttributeKind::FogCoord, 0}, fragment)[0];
  m_inputs.secondary = attributeValue({AttributeKind::ColorSecondary, 0}, fragment);
  m_inputs.parameter = parameterValue;
  m_inputs.texture = sampleTexture;
  m_inputs.numerics = Numerics::Legacy; // as the chip multiplies
}

} // namespace arbiter::r300
