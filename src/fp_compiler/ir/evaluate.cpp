#include "fp_compiler/ir/evaluate.h"

#include <cmath>
#include <limits>

#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::ir {

namespace {
class Machine {
public:
  Machine(const Program &program, const Inputs &inputs)
      : m_program(program), m_inputs(inputs), m_temporaries(program.temporaries.size(), Vec4{}),
        m_parameters(program.parameters.size()), m_addresses(program.addresses.size(), 0) {
    m_evaluation.outputs.assign(program.outputs.size(), Vec4{});
    for (std::size_t i = 0; i < m_parameters.size(); ++i)
      m_parameters[i] = resolve(program.parameters[i]);
  }

  Evaluation run() {
    for (const Instruction &instruction : m_program.code) {
      step(instruction);
      if (m_evaluation.killed) {
        m_evaluation.outputs.assign(m_program.outputs.size(), Vec4{});
        m_evaluation.depth.reset();
        return m_evaluation;
      }
    }
    if (m_program.options.colorSum)
      colorSum();
    if (m_program.options.fog != FogMode::None)
      fog();
    return m_evaluation;
  }

private:
  Vec4 resolve(const Parameter &parameter) const {
    if (parameter.kind == ParameterKind::Constant)
      return parameter.constant;
    return m_inputs.parameter ? m_inputs.parameter(parameter) : Vec4{};
  }

  Vec4 element(const Operand &operand) const {
    const auto &rows = m_program.arrays[operand.index].rows;
    const std::int64_t row = std::int64_t(m_addresses[operand.address]) + operand.offset;
    return row >= 0 && row < std::int64_t(rows.size()) ? m_parameters[rows[std::size_t(row)]]
                                                       : Vec4{};
  }

  Vec4 fetch(const Operand &operand) const {
    Vec4 source = {};
    switch (operand.file) {
    case File::Temporary:
      source = m_temporaries[operand.index];
      break;
    case File::Attribute:
      if (operand.index < m_inputs.attributes.size())
        source = m_inputs.attributes[operand.index];
      break;
    case File::Parameter:
      source = operand.relative ? element(operand) : m_parameters[operand.index];
      break;
    case File::Output:
    case File::Address:
      break; // write only; validate() reports it
    }
    Vec4 value;
    for (std::size_t i = 0; i < 4; ++i) {
      const Select select = operand.swizzle[i];
      value[i] = select == Select::Zero  ? 0.0f
                 : select == Select::One ? 1.0f
                                         : source[std::size_t(select)];
      value[i] = flushed(operand.negate >> i & 1 ? -value[i] : value[i]);
    }
    return value;
  }

  Vec4 sample(const Instruction &instruction) const {
    const Vec4 value = fetch(instruction.src[0]);
    Sample request;
    request.target = instruction.target;
    request.unit = instruction.unit;
    for (std::size_t i = 0; i < 3; ++i)
      if (coordinateMask(instruction.target) >> i & 1)
        request.coordinate[i] = instruction.op == Opcode::Txp ? value[i] / value[3] : value[i];
    if (instruction.op == Opcode::Txb && (operandMask(instruction, 0) & 8))
      request.bias = value[3];
    return m_inputs.texture ? m_inputs.texture(request) : Vec4{};
  }

  void step(const Instruction &instruction) {
    const OpInfo &row = info(instruction.op);
    if (row.has(Kills)) {
      m_evaluation.killed = kills(fetch(instruction.src[0]));
      return;
    }
    Vec4 value;
    if (row.has(Texture)) {
      value = sample(instruction);
    } else {
      Operands operands = {};
      for (std::size_t i = 0; i < std::size_t(row.operandCount()); ++i)
        operands[i] = fetch(instruction.src[i]);
      if (m_inputs.operands)
        m_inputs.operands(instruction, operands);
      value = apply(instruction.op, operands, m_inputs.numerics);
    }
    if (m_inputs.result)
      m_inputs.result(instruction, value);
    write(instruction.dst, value);
  }

  /// An index beyond 32 bits, or NaN, is one that no array has.
  static std::int32_t addressOf(float value) {
    return std::fabs(value) < 1073741824.0f ? std::int32_t(value)
                                            : std::numeric_limits<std::int32_t>::min();
  }

  void write(const Destination &dst, const Vec4 &value) {
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

  Vec4 stateRow(StateItem item) const {
    Parameter parameter;
    parameter.kind = ParameterKind::State;
    parameter.state.item = item;
    return resolve(parameter);
  }

  float fogFactor() const {
    const Vec4 params = stateRow(StateItem::FogParams);
    const float c = m_inputs.fogCoordinate;
    constexpr float kMinusOneOverLn2 = -1.442695041f;
    switch (m_program.options.fog) {
    case FogMode::None:
      break;
    case FogMode::Exp:
      return saturated(std::exp2(params[0] * c * kMinusOneOverLn2));
    case FogMode::Exp2:
      return saturated(std::exp2(params[0] * c * params[0] * c * kMinusOneOverLn2));
    case FogMode::Linear:
      return saturated((params[2] - c) / (params[2] - params[1]));
    }
    return 1.0f;
  }

  void colorSum() {
    for (std::size_t o = 0; o < m_program.outputs.size(); ++o)
      if (m_program.outputs[o].kind == OutputKind::Color)
        for (std::size_t i = 0; i < 3; ++i)
          m_evaluation.outputs[o][i] =
              saturated(m_evaluation.outputs[o][i]) + m_inputs.secondary[i];
  }

  void fog() {
    const float factor = fogFactor();
    const Vec4 color = stateRow(StateItem::FogColor);
    for (std::size_t o = 0; o < m_program.outputs.size(); ++o)
      if (m_program.outputs[o].kind == OutputKind::Color)
        for (std::size_t i = 0; i < 4; ++i) {
          float &value = m_evaluation.outputs[o][i];
          value = saturated(value);
          if (i < 3)
            value = factor * value + (1.0f - factor) * color[i];
        }
  }

  const Program &m_program;
  const Inputs &m_inputs;
  std::vector<Vec4> m_temporaries, m_parameters;
  std::vector<std::int32_t> m_addresses;
  Evaluation m_evaluation;
};
} // namespace

Evaluation evaluate(const Program &program, const Inputs &inputs) {
  return Machine(program, inputs).run();
}

} // namespace arbiter::fp::ir
