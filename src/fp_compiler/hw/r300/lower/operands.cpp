#include "fp_compiler/hw/r300/lower/operands.h"

namespace arbiter::fp::hw::r300 {

/// Computes fragment.position from the clip position: (x/w, y/w, z/w) * scale + offset, and 1/w.
Refs Operands::position(std::uint16_t attribute) {
  const Value clip = valueOf(m_emit.interpolant(attribute));
  EmitOptions options;
  options.cause = Cause::Position;
  const Value inverse = m_emit.scalar(AlphaOp::Rcp, 8, clip, options);
  // Adding -0 keeps the sign of a zero.
  const Value device = m_emit.mad(7, clip, inverse, literals(-0.0f), options);
  const Value window = m_emit.mad(7, device, row(Constant::Kind::ViewportScale, 0),
                                  row(Constant::Kind::ViewportOffset, 0), options);
  Refs refs = window.direct;
  refs[3] = inverse.direct[3];
  return refs;
}

Value Operands::row(Constant::Kind kind, std::uint16_t index) {
  return rowValue(m_emit.rows().own(kind, index, m_emit.origin()));
}

Value Operands::rowValue(std::uint16_t index) {
  Refs refs;
  for (std::uint8_t c = 0; c < 4; ++c)
    refs[c] = {Ref::Kind::Row, c, false, false, index, 0.0f};
  return valueOf(refs);
}

const Value &Operands::attribute(std::uint16_t index) {
  Attribute &attribute = m_attributes[index];
  if (!attribute.loaded) {
    attribute.loaded = true;
    attribute.value = valueOf(m_program.attributes[index].kind == ir::AttributeKind::Position
                                  ? position(index)
                                  : m_emit.interpolant(index));
  }
  return attribute.value;
}

Value Operands::parameter(std::uint16_t index) {
  const ir::Parameter &parameter = m_program.parameters[index];
  if (parameter.kind != ir::ParameterKind::Constant)
    return rowValue(m_emit.rows().parameter(index, m_emit.origin()));
  Refs refs;
  for (std::uint8_t c = 0; c < 4; ++c)
    refs[c] = {Ref::Kind::Literal, c, false, false, index, parameter.constant[c]};
  return valueOf(refs);
}

Value Operands::whole(const ir::Operand &operand) {
  switch (operand.file) {
  case ir::File::Attribute:
    return attribute(operand.index);
  case ir::File::Parameter:
    return parameter(operand.index);
  case ir::File::Temporary:
    return m_emit.current(operand.index);
  case ir::File::Output:
  case ir::File::Address:
    break; // validate() rejects it
  }
  return literals(0.0f);
}

Value Operands::read(const ir::Operand &operand) {
  const Value source = whole(operand);
  Value value;
  value.once = source.once;
  for (std::size_t c = 0; c < 4; ++c) {
    const ir::Select select = operand.swizzle[c];
    if (select >= ir::Select::Zero) {
      value.direct[c] = value.through[c] = literal(select == ir::Select::One ? 1.0f : 0.0f);
    } else {
      value.direct[c] = source.direct[std::size_t(select)];
      const Ref &through = source.through[std::size_t(select)];
      // The source of a copy may have been overwritten since. The copy then stays.
      value.through[c] = m_emit.readable(through) ? through : value.direct[c];
    }
    if (operand.negate >> c & 1) {
      value.direct[c] = negated(value.direct[c]);
      value.through[c] = negated(value.through[c]);
    }
  }
  return value;
}

std::uint16_t Operands::attributeOf(ir::AttributeKind kind, std::uint16_t otherwise) const {
  for (std::size_t i = 0; i < m_program.attributes.size(); ++i)
    if (m_program.attributes[i].kind == kind)
      return std::uint16_t(i);
  return otherwise;
}

Value Operands::attributeOr(ir::AttributeKind kind, std::uint16_t otherwise) {
  const std::uint16_t index = attributeOf(kind, otherwise);
  return index == otherwise ? valueOf(m_emit.interpolant(index)) : attribute(index);
}

} // namespace arbiter::fp::hw::r300
