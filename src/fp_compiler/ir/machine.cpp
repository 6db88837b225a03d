#include "fp_compiler/ir/machine.h"

#include <cmath>
#include <limits>

#include "fp_compiler/ir/fog.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::ir {

Machine::Machine(const Program &program, const Inputs &inputs)
    : m_program(program), m_inputs(inputs),
      m_numerics(numericsOf(program.language, inputs.numerics)),
      m_bits(program.options.nv != NvOption::None), m_temporaries(program.temporaries.size()),
      m_attributes(inputs.attributes.begin(), inputs.attributes.end()),
      m_parameters(program.parameters.size()), m_addresses(program.addresses.size(), 0) {
  m_evaluation.outputs.assign(program.outputs.size(), Vec4{});
  m_attributes.resize(program.attributes.size(), Vec4{});
  for (std::size_t i = 0; i < m_attributes.size(); ++i)
    m_attributes[i] = read(m_attributes[i], program.attributes[i].kind);
  for (std::size_t i = 0; i < m_parameters.size(); ++i)
    m_parameters[i] = resolve(program.parameters[i]);
}

void Machine::step(std::size_t index) {
  const Instruction &instruction = m_program.code[index];
  const OpInfo &row = info(instruction.op);
  const bool bits = m_bits && carriesBits(instruction.op);
  Step done;
  done.index = index;
  for (std::size_t i = 0; i < std::size_t(row.operandCount()); ++i)
    done.operands[i] = fetch(instruction.src[i], bits);
  if (row.has(Kills)) {
    done.discards = kills(done.operands[0]);
    m_evaluation.killed |= done.discards;
  } else {
    write(instruction.dst, result(instruction, done));
  }
  if (!m_inputs.observer)
    return;
  if (!row.has(Kills))
    done.value = contents(instruction.dst);
  m_inputs.observer(done);
}

/// Returns an attribute as instructions of the mode read it.
Vec4 Machine::read(Vec4 value, AttributeKind kind) const {
  const bool color = kind == AttributeKind::ColorPrimary || kind == AttributeKind::ColorSecondary;
  for (float &component : value)
    component = color && m_numerics == Numerics::Fp24 ? fp24::color(component)
                                                      : held(component, m_numerics);
  return value;
}

Vec4 Machine::given(const Parameter &parameter) const {
  if (parameter.kind == ParameterKind::Constant)
    return parameter.constant;
  if (parameter.kind == ParameterKind::State && parameter.state.item == StateItem::FogFactors)
    return fogFactors(given(stateRow(StateItem::FogParams)));
  return m_inputs.parameter ? m_inputs.parameter(parameter) : Vec4{};
}

/// Returns a row of parameters as instructions of the mode read it.
Vec4 Machine::resolve(const Parameter &parameter) const {
  Vec4 value = given(parameter);
  if (m_bits && m_numerics != Numerics::Fp24)
    return value;
  for (float &component : value)
    component = loaded(component, m_numerics);
  return value;
}

Vec4 Machine::element(const Operand &operand) const {
  const auto &rows = m_program.arrays[operand.index].rows;
  const std::int64_t row = std::int64_t(m_addresses[operand.address]) + operand.offset;
  return row >= 0 && row < std::int64_t(rows.size()) ? m_parameters[rows[std::size_t(row)]]
                                                     : Vec4{};
}

/// Reads an operand.
/// \param bits true to keep denormals
Vec4 Machine::fetch(const Operand &operand, bool bits) const {
  Vec4 source = {};
  switch (operand.file) {
  case File::Temporary:
    source = m_temporaries[operand.index];
    break;
  case File::Attribute:
    source = m_attributes[operand.index];
    break;
  case File::Parameter:
    source = operand.relative ? element(operand) : m_parameters[operand.index];
    break;
  case File::Output:
  case File::Address:
    break; // write only; validate() rejects a read
  }
  Vec4 value;
  for (std::size_t i = 0; i < 4; ++i) {
    const Select select = operand.swizzle[i];
    value[i] = select == Select::Zero  ? 0.0f
               : select == Select::One ? 1.0f
                                       : source[std::size_t(select)];
    value[i] = operand.negate >> i & 1 ? -value[i] : value[i];
    if (!bits)
      value[i] = flushed(value[i]);
  }
  return value;
}

/// Returns the level of detail that the instruction gives. A vertex program samples the base level
/// unless TXL gives one. TXB is TXL there.
std::optional<float> Machine::levelOf(const Instruction &instruction, const Vec4 &value) const {
  const bool vertex = m_program.language == Language::ArbVertex;
  const bool given = instruction.op == Opcode::Txl || (vertex && instruction.op == Opcode::Txb);
  if (given && (operandMask(instruction, 0) & 8))
    return value[3];
  return given || vertex ? std::optional(0.0f) : std::nullopt;
}

namespace {
/// Returns the derivatives of TXD.
Sample::Gradient gradientOf(const Instruction &instruction, const Operands &operands) {
  Sample::Gradient gradient;
  for (std::size_t i = 0; i < 3; ++i)
    if (operandMask(instruction, 1) >> i & 1) {
      gradient.x[i] = operands[1][i];
      gradient.y[i] = operands[2][i];
    }
  return gradient;
}
} // namespace

Sample Machine::requestOf(const Instruction &instruction, const Operands &operands) const {
  const Vec4 &value = operands[0];
  Sample request;
  request.target = instruction.target;
  request.unit = instruction.unit;
  for (std::size_t i = 0; i < 3; ++i)
    if (coordinateMask(instruction.target) >> i & 1)
      request.coordinate[i] = instruction.op == Opcode::Txp ? value[i] / value[3] : value[i];
  if (instruction.op == Opcode::Txb && (operandMask(instruction, 0) & 8))
    request.bias = value[3];
  request.lod = levelOf(instruction, value);
  if (request.lod)
    request.bias = 0.0f;
  if (instruction.op == Opcode::Txd)
    request.gradient = gradientOf(instruction, operands);
  return request;
}

Vec4 Machine::sample(const Sample &request) const {
  Vec4 texel = m_inputs.texture ? m_inputs.texture(request) : Vec4{};
  for (float &component : texel)
    component = held(component, m_numerics);
  return texel;
}

Vec4 Machine::arithmetic(const Instruction &instruction, const Operands &operands) const {
  if (instruction.op == Opcode::Ddx || instruction.op == Opcode::Ddy)
    return m_derivative ? *m_derivative : apply(Opcode::Ddx, operands, m_numerics);
  return m_bits && carriesBits(instruction.op)
             ? applyToBits(instruction.op, operands)
             : apply(instruction.op, operands, m_numerics, m_program.language);
}

/// Returns the instruction's result, before _SAT.
Vec4 Machine::result(const Instruction &instruction, Step &done) const {
  Vec4 value;
  if (info(instruction.op).has(Texture)) {
    done.sample = requestOf(instruction, done.operands);
    value = sample(*done.sample);
  } else {
    if (m_inputs.operands)
      m_inputs.operands(instruction, done.operands);
    value = arithmetic(instruction, done.operands);
  }
  if (m_inputs.result)
    m_inputs.result(instruction, value);
  return value;
}

/// Returns the value of the destination register.
Vec4 Machine::contents(const Destination &dst) const {
  if (dst.file == File::Address)
    return {float(m_addresses[dst.index])};
  return dst.file == File::Output ? m_evaluation.outputs[dst.index] : m_temporaries[dst.index];
}

namespace {
/// Returns the address of a value. An index beyond 32 bits, or NaN, gives one that no array has.
std::int32_t addressOf(float value) {
  return std::fabs(value) < 1073741824.0f ? std::int32_t(value)
                                          : std::numeric_limits<std::int32_t>::min();
}
} // namespace

void Machine::write(const Destination &dst, const Vec4 &value) {
  if (dst.file == File::Address) {
    m_addresses[dst.index] = addressOf(value[0]);
    return;
  }
  Vec4 &target =
      dst.file == File::Output ? m_evaluation.outputs[dst.index] : m_temporaries[dst.index];
  for (std::size_t i = 0; i < 4; ++i)
    if (dst.mask >> i & 1)
      target[i] = dst.saturate ? saturated(value[i]) : value[i];
  if (dst.file == File::Output && (dst.mask & 4) &&
      m_program.outputs[dst.index].kind == OutputKind::Depth)
    m_evaluation.depth = target[2];
}

} // namespace arbiter::fp::ir
