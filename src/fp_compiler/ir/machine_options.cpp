#include <algorithm>

#include "fp_compiler/ir/fog.h"
#include "fp_compiler/ir/machine.h"

namespace arbiter::fp::ir {

namespace {
Vec4 clamped(Vec4 value) {
  for (float &component : value)
    component = saturated(component);
  return value;
}
} // namespace

float Machine::compute(Opcode op, float a, float b, float c) const {
  return apply(op, {Vec4{a}, Vec4{b}, Vec4{c}}, m_numerics)[0];
}

/// Returns the fog factor before its clamp.
float Machine::fogFactor() const {
  const Vec4 row = resolve(stateRow(StateItem::FogFactors));
  const float c = held(m_inputs.fogCoordinate, m_numerics);
  switch (m_program.options.fog) {
  case FogMode::None:
    break;
  case FogMode::Exp:
    return compute(Opcode::Ex2, compute(Opcode::Mul, c, row[2]));
  case FogMode::Exp2: {
    const float root = compute(Opcode::Mul, c, row[3]);
    return compute(Opcode::Ex2, -compute(Opcode::Mul, root, root));
  }
  case FogMode::Linear:
    return compute(Opcode::Mad, c, row[0], row[1]);
  }
  return 1.0f;
}

void Machine::colorSum() {
  const Vec4 secondary = read(m_inputs.secondary, AttributeKind::ColorSecondary);
  for (std::size_t o = 0; o < m_program.outputs.size(); ++o)
    if (m_program.outputs[o].kind == OutputKind::Color) {
      Vec4 &value = m_evaluation.outputs[o];
      const Vec4 sum = apply(Opcode::Add, {clamped(value), secondary}, m_numerics);
      std::copy_n(sum.begin(), 3, value.begin());
    }
}

void Machine::fog() {
  const float factor = saturated(fogFactor());
  const Vec4 color = resolve(stateRow(StateItem::FogColor));
  for (std::size_t o = 0; o < m_program.outputs.size(); ++o)
    if (m_program.outputs[o].kind == OutputKind::Color) {
      Vec4 &value = m_evaluation.outputs[o];
      value = clamped(value);
      const Vec4 blend =
          apply(Opcode::Lrp, {Vec4{factor, factor, factor}, value, color}, m_numerics);
      std::copy_n(blend.begin(), 3, value.begin());
    }
}

} // namespace arbiter::fp::ir
