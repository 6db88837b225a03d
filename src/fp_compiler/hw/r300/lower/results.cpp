#include "fp_compiler/hw/r300/lower/results.h"

namespace arbiter::fp::hw::r300 {

/// Returns a result, clamped. Only the program's options read it, so the operations that compute it
/// can clamp.
Value Results::clamped(Variable output, std::uint8_t mask) {
  Value value = m_emit.current(output);
  bool inPlace = true;
  for (std::size_t c = 0; c < 4; ++c) {
    const Ref &ref = value.direct[c];
    if ((mask >> c & 1) && ref.kind == Ref::Kind::Item)
      inPlace &= !m_flow.items[ref.index].replicated || mask == 15;
  }
  value.through = value.direct;
  if (!inPlace) {
    EmitOptions options;
    options.toDestination = true;
    options.clamp = true;
    options.cause = Cause::Output;
    return m_emit.copy(mask, value, options);
  }
  for (std::size_t c = 0; c < 4; ++c)
    if ((mask >> c & 1) && value.direct[c].kind == Ref::Kind::Item)
      m_flow.items[value.direct[c].index].clamp = true;
  return value;
}

void Results::epilogue() {
  const ir::Options &options = m_program.options;
  if (options.colorSum) {
    const Value secondary =
        m_operands.attributeOr(ir::AttributeKind::ColorSecondary, kSecondaryColor);
    for (std::size_t i = 0; i < m_program.outputs.size(); ++i)
      if (isColor(i)) {
        EmitOptions sum;
        sum.toDestination = true;
        sum.cause = Cause::Output;
        m_emit.begin(kNone, outputVariable(i));
        const Value color = clamped(outputVariable(i), 7);
        m_emit.begin(kNone, outputVariable(i));
        m_emit.set(outputVariable(i), 7, m_emit.mad(7, color, literals(1.0f), secondary, sum));
      }
  }
  if (options.fog != ir::FogMode::None)
    fog();
}

Value Results::fogFactor() {
  const Value coordinate =
      broadcast(m_operands.attributeOr(ir::AttributeKind::FogCoord, kFogCoordinate), 0);
  const Value factors = m_operands.row(Constant::Kind::FogFactors, 0);
  EmitOptions partial, last;
  partial.cause = last.cause = Cause::Fog;
  last.clamp = true;
  const Value none = literals(-0.0f);
  switch (m_program.options.fog) {
  case ir::FogMode::None:
    break;
  case ir::FogMode::Linear:
    return m_emit.mad(8, coordinate, broadcast(factors, 0), broadcast(factors, 1), last);
  case ir::FogMode::Exp:
    return m_emit.scalar(AlphaOp::Ex2, 8,
                         m_emit.mad(8, coordinate, broadcast(factors, 2), none, partial), last);
  case ir::FogMode::Exp2: {
    const Value scaled = m_emit.mad(8, coordinate, broadcast(factors, 3), none, partial);
    return m_emit.scalar(AlphaOp::Ex2, 8, m_emit.mad(8, scaled, negated(scaled), none, partial),
                         last);
  }
  }
  return literals(1.0f);
}

void Results::fog() {
  m_emit.begin(kNone, kNoVariable);
  const Value factor = broadcast(fogFactor(), 3);
  for (std::size_t i = 0; i < m_program.outputs.size(); ++i)
    if (isColor(i)) {
      EmitOptions options;
      options.toDestination = true;
      options.cause = Cause::Fog;
      m_emit.begin(kNone, outputVariable(i));
      const Value color = clamped(outputVariable(i), 15);
      m_emit.set(outputVariable(i), 15, color);
      m_emit.begin(kNone, outputVariable(i));
      m_emit.set(
          outputVariable(i), 7,
          m_emit.lerp(7, factor, color, m_operands.row(Constant::Kind::FogColor, 0), options));
    }
}

void Results::outputs() {
  for (std::size_t i = 0; i < m_program.outputs.size(); ++i) {
    const Value &value = m_emit.current(outputVariable(i));
    if (!isColor(i)) {
      depthOutput(value);
      continue;
    }
    for (std::uint8_t c = 0; c < 4; ++c)
      if (!write(value.through[c], m_program.outputs[i].index, c))
        (void)write(value.direct[c], m_program.outputs[i].index, c);
  }
}

bool Results::write(const Ref &ref, std::uint8_t target, std::uint8_t component) {
  if (ref.kind != Ref::Kind::Item || ref.negate || ref.absolute)
    return false;
  Item &item = m_flow.items[ref.index];
  if (!item.isAlu() || (ref.component != component && !item.replicated) ||
      (item.outputMask && item.output != target))
    return false;
  item.output = target;
  item.outputMask |= std::uint8_t(1 << component);
  return true;
}

void Results::depthOutput(const Value &value) {
  for (const Ref &ref : {value.through[3], value.direct[3]}) {
    if (ref.kind != Ref::Kind::Item || ref.negate || ref.absolute)
      continue;
    Item &item = m_flow.items[ref.index];
    if (!item.isAlu() || (ref.component != 3 && !item.replicated))
      continue;
    item.depth = true;
    return;
  }
}

} // namespace arbiter::fp::hw::r300
