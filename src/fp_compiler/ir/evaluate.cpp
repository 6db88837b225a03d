#include "fp_compiler/ir/evaluate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::ir {

namespace {
class Machine {
public:
  Machine(const Program &program, const Inputs &inputs)
      : m_program(program), m_inputs(inputs),
        m_numerics(numericsOf(program.language, inputs.numerics)),
        m_temporaries(program.temporaries.size(), Vec4{}),
        m_attributes(inputs.attributes.begin(), inputs.attributes.end()),
        m_parameters(program.parameters.size()), m_addresses(program.addresses.size(), 0) {
    m_evaluation.outputs.assign(program.outputs.size(), Vec4{});
    m_attributes.resize(program.attributes.size(), Vec4{});
    for (std::size_t i = 0; i < m_attributes.size(); ++i)
      m_attributes[i] = read(m_attributes[i], program.attributes[i].kind);
    for (std::size_t i = 0; i < m_parameters.size(); ++i)
      m_parameters[i] = resolve(program.parameters[i]);
  }

  Evaluation run() {
    while (m_at < m_program.code.size() && goesOn())
      advance();
    return finish();
  }

  /// The instruction that is next.
  [[nodiscard]] std::size_t at() const { return m_at; }

  /// Does it.
  void advance() {
    const Instruction &instruction = m_program.code[m_at];
    if (!info(instruction.op).has(Flow))
      return step(m_at++);
    switch (instruction.op) {
    case Opcode::Rep:
      m_loops.push_back({m_at, iterations(fetch(instruction.src[0])[0])});
      return iterate();
    case Opcode::Endrep:
      return iterate();
    default: // BRK
      if (fetch(instruction.src[0])[0] == 0.0f) {
        ++m_at;
        return;
      }
      m_at = endOf(m_loops.back().begin) + 1;
      m_loops.pop_back();
    }
  }

  [[nodiscard]] bool goesOn() const { return !m_evaluation.killed || m_inputs.pastKill; }

  Evaluation finish() {
    if (!goesOn()) {
      m_evaluation.outputs.assign(m_program.outputs.size(), Vec4{});
      m_evaluation.depth.reset();
      return m_evaluation;
    }
    if (m_program.options.colorSum)
      colorSum();
    if (m_program.options.fog != FogMode::None)
      fog();
    return m_evaluation;
  }

  /// What the operand of a derivative is, and the derivative, for step() to take.
  [[nodiscard]] Vec4 operandOf(std::size_t index) const {
    return fetch(m_program.code[index].src[0]);
  }
  void setDerivative(const Vec4 &value) { m_derivative = value; }

  void step(std::size_t index) {
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

private:
  /// An attribute as the mode's instructions read it.
  Vec4 read(Vec4 value, AttributeKind kind) const {
    const bool color = kind == AttributeKind::ColorPrimary || kind == AttributeKind::ColorSecondary;
    for (float &component : value)
      component = color && m_numerics == Numerics::Fp24 ? fp24::colour(component)
                                                        : held(component, m_numerics);
    return value;
  }

  Vec4 given(const Parameter &parameter) const {
    if (parameter.kind == ParameterKind::Constant)
      return parameter.constant;
    return m_inputs.parameter ? m_inputs.parameter(parameter) : Vec4{};
  }

  /// A row as the mode's instructions read it.
  Vec4 resolve(const Parameter &parameter) const {
    Vec4 value = given(parameter);
    if (m_bits && m_numerics != Numerics::Fp24)
      return value;
    for (float &component : value)
      component = loaded(component, m_numerics);
    return value;
  }

  Vec4 element(const Operand &operand) const {
    const auto &rows = m_program.arrays[operand.index].rows;
    const std::int64_t row = std::int64_t(m_addresses[operand.address]) + operand.offset;
    return row >= 0 && row < std::int64_t(rows.size()) ? m_parameters[rows[std::size_t(row)]]
                                                       : Vec4{};
  }

  /// \param bits as they are, denormals too
  Vec4 fetch(const Operand &operand, bool bits = false) const {
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
      break; // write only; validate() reports it
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

  /// In a vertex program the level is the base's, but for TXB's, which is TXL's there.
  [[nodiscard]] std::optional<float> levelOf(const Instruction &instruction,
                                             const Vec4 &value) const {
    const bool vertex = m_program.language == Language::ArbVertex;
    const bool given = instruction.op == Opcode::Txl || (vertex && instruction.op == Opcode::Txb);
    if (given && (operandMask(instruction, 0) & 8))
      return value[3];
    return given || vertex ? std::optional(0.0f) : std::nullopt;
  }

  [[nodiscard]] Sample requestOf(const Instruction &instruction, const Vec4 &value) const {
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
    return request;
  }

  /// TXD's.
  static Sample::Gradient gradientOf(const Instruction &instruction, const Operands &operands) {
    Sample::Gradient gradient;
    for (std::size_t i = 0; i < 3; ++i)
      if (operandMask(instruction, 1) >> i & 1) {
        gradient.x[i] = operands[1][i];
        gradient.y[i] = operands[2][i];
      }
    return gradient;
  }

  Vec4 sample(const Sample &request) const {
    Vec4 texel = m_inputs.texture ? m_inputs.texture(request) : Vec4{};
    for (float &component : texel)
      component = held(component, m_numerics);
    return texel;
  }

  Vec4 derivative(const Step &done) const {
    return m_derivative ? *m_derivative : apply(Opcode::Ddx, done.operands, m_numerics);
  }

  /// What the instruction makes, before _SAT.
  Vec4 result(const Instruction &instruction, Step &done) const {
    Vec4 value;
    if (info(instruction.op).has(Texture)) {
      done.sample = requestOf(instruction, done.operands[0]);
      if (instruction.op == Opcode::Txd)
        done.sample->gradient = gradientOf(instruction, done.operands);
      value = sample(*done.sample);
    } else {
      if (m_inputs.operands)
        m_inputs.operands(instruction, done.operands);
      value = instruction.op == Opcode::Ddx || instruction.op == Opcode::Ddy ? derivative(done)
              : m_bits && carriesBits(instruction.op)
                  ? applyToBits(instruction.op, done.operands)
                  : apply(instruction.op, done.operands, m_numerics, m_program.language);
    }
    if (m_inputs.result)
      m_inputs.result(instruction, value);
    return value;
  }

  /// What the destination holds now.
  Vec4 contents(const Destination &dst) const {
    if (dst.file == File::Address)
      return {float(m_addresses[dst.index])};
    return dst.file == File::Output ? m_evaluation.outputs[dst.index] : m_temporaries[dst.index];
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

  static Parameter stateRow(StateItem item) {
    Parameter parameter;
    parameter.kind = ParameterKind::State;
    parameter.state.item = item;
    return parameter;
  }

  float compute(Opcode op, float a, float b = 0, float c = 0) const {
    return apply(op, {Vec4{a}, Vec4{b}, Vec4{c}}, m_numerics)[0];
  }

  /// Before its clamp. The rows that a chip's driver would load are made in singles.
  float fogFactor() const {
    const Vec4 params = given(stateRow(StateItem::FogParams));
    const float c = held(m_inputs.fogCoordinate, m_numerics);
    const auto scaled = [&](float value) {
      return compute(Opcode::Mul, c, loaded(value, m_numerics));
    };
    constexpr float kOneOverLn2 = 1.442695041f, kOneOverRootLn2 = 1.201122409f;
    switch (m_program.options.fog) {
    case FogMode::None:
      break;
    case FogMode::Exp:
      return compute(Opcode::Ex2, -scaled(params[0] * kOneOverLn2));
    case FogMode::Exp2: {
      const float root = scaled(params[0] * kOneOverRootLn2);
      return compute(Opcode::Ex2, -compute(Opcode::Mul, root, root));
    }
    case FogMode::Linear:
      if (m_numerics != Numerics::Fp24)
        return (params[2] - c) / (params[2] - params[1]);
      return compute(Opcode::Mad, c, loaded(-params[3], m_numerics),
                     loaded(params[2] * params[3], m_numerics));
    }
    return 1.0f;
  }

  void colorSum() {
    const Vec4 secondary = read(m_inputs.secondary, AttributeKind::ColorSecondary);
    for (std::size_t o = 0; o < m_program.outputs.size(); ++o)
      if (m_program.outputs[o].kind == OutputKind::Color) {
        Vec4 &value = m_evaluation.outputs[o];
        const Vec4 sum = apply(Opcode::Add, {clamped(value), secondary}, m_numerics);
        std::copy_n(sum.begin(), 3, value.begin());
      }
  }

  void fog() {
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

  static Vec4 clamped(Vec4 value) {
    for (float &component : value)
      component = saturated(component);
    return value;
  }

  struct Loop {
    std::size_t begin = 0;  ///< its REP
    std::uint32_t left = 0; ///< iterations that have not begun
  };

  /// Begins the next iteration of the innermost loop, or leaves it.
  void iterate() {
    Loop &loop = m_loops.back();
    if (loop.left > 0 && m_begun < kMostIterations) {
      --loop.left;
      ++m_begun;
      m_at = loop.begin + 1;
      return;
    }
    m_at = endOf(loop.begin) + 1;
    m_loops.pop_back();
  }

  [[nodiscard]] std::size_t endOf(std::size_t begin) const {
    std::size_t depth = 0;
    for (std::size_t i = begin;; ++i) {
      depth += m_program.code[i].op == Opcode::Rep ? 1 : 0;
      if (m_program.code[i].op == Opcode::Endrep && --depth == 0)
        return i;
    }
  }

  const Program &m_program;
  const Inputs &m_inputs;
  const Numerics m_numerics;
  const bool m_bits = m_program.options.nv != NvOption::None; ///< registers hold bits
  std::optional<Vec4> m_derivative;
  std::size_t m_at = 0;
  std::vector<Loop> m_loops;
  std::uint32_t m_begun = 0; ///< iterations, of all loops
  std::vector<Vec4> m_temporaries, m_attributes, m_parameters;
  std::vector<std::int32_t> m_addresses;
  Evaluation m_evaluation;
};
} // namespace

Evaluation evaluate(const Program &program, const Inputs &inputs) {
  return Machine(program, inputs).run();
}

std::array<Evaluation, 4> evaluateQuad(const Program &program,
                                       const std::array<Inputs, 4> &inputs) {
  // A discarded fragment goes on for its neighbours.
  std::array<Inputs, 4> helped = inputs;
  for (Inputs &lane : helped)
    lane.pastKill = true;
  std::array<Machine, 4> lanes = {Machine(program, helped[0]), Machine(program, helped[1]),
                                  Machine(program, helped[2]), Machine(program, helped[3])};
  const auto together = [&] {
    return std::all_of(lanes.begin(), lanes.end(),
                       [&](const Machine &lane) { return lane.at() == lanes[0].at(); });
  };
  while (lanes[0].at() < program.code.size() && together()) {
    const std::size_t i = lanes[0].at();
    const Opcode op = program.code[i].op;
    if (op == Opcode::Ddx || op == Opcode::Ddy) {
      std::array<Vec4, 4> value;
      for (std::size_t lane = 0; lane < 4; ++lane)
        value[lane] = lanes[lane].operandOf(i);
      for (std::size_t lane = 0; lane < 4; ++lane) {
        const std::size_t low = op == Opcode::Ddx ? lane & 2 : lane & 1;
        const std::size_t high = low + (op == Opcode::Ddx ? 1 : 2);
        lanes[lane].setDerivative(
            apply(Opcode::Sub, {value[high], value[low]}, inputs[lane].numerics));
      }
    }
    for (Machine &lane : lanes)
      lane.advance();
  }
  // Loops that run another number of times: from here on no fragment has neighbours.
  for (Machine &lane : lanes) {
    lane.setDerivative({});
    while (lane.at() < program.code.size())
      lane.advance();
  }
  std::array<Evaluation, 4> results;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    results[lane] = lanes[lane].finish();
    if (!results[lane].killed || inputs[lane].pastKill)
      continue;
    results[lane].outputs.assign(program.outputs.size(), Vec4{});
    results[lane].depth.reset();
  }
  return results;
}

} // namespace arbiter::fp::ir
