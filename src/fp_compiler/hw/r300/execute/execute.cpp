#include "fp_compiler/hw/r300/execute/execute.h"

#include <algorithm>
#include <cmath>

#include "fp_compiler/hw/r300/check/reads.h"
#include "fp_compiler/hw/r300/execute/load.h"

namespace arbiter::fp::hw::r300 {

using ir::Opcode;
using ir::Operands;
using ir::Vec4;

namespace {
using Color = std::array<float, 3>;

float scaled(float value, Modifier modifier) {
  constexpr float kFactors[] = {1.0f, 2.0f, 4.0f, 8.0f, 0.5f, 0.25f, 0.125f};
  return value * kFactors[std::size_t(modifier)];
}

template <typename Half> float finished(const Half &half, float value) {
  value = ir::flushed(scaled(value, half.modifier));
  return half.clamp ? ir::saturated(value) : value;
}

class Machine {
public:
  Machine(const Code &code, const ir::Program &program, const ir::Inputs &inputs)
      : m_code(code), m_program(program), m_inputs(inputs),
        m_numerics(inputs.numerics == Numerics::Host ? Numerics::Legacy : inputs.numerics),
        m_registers(code.temporaries, Vec4{}) {
    m_evaluation.outputs.assign(program.outputs.size(), Vec4{});
    for (const Constant &constant : code.constants)
      m_constants.push_back(constantOf(constant, {program, inputs, m_numerics}));
    for (const Interpolant &interpolant : code.interpolants)
      m_registers[interpolant.temporary] =
          interpolantOf(interpolant.attribute, {program, inputs, m_numerics});
  }

  ir::Evaluation run() {
    for (const Node &node : m_code.nodes) {
      textures(node);
      if (m_evaluation.killed) {
        m_evaluation.outputs.assign(m_program.outputs.size(), Vec4{});
        m_evaluation.depth.reset();
        return m_evaluation;
      }
      for (std::uint32_t i = 0; i < node.pairs; ++i)
        step(m_code.pairs[node.firstPair + i]);
    }
    return m_evaluation;
  }

private:
  bool scalesRectangle(std::uint8_t unit) const {
    return std::any_of(m_code.constants.begin(), m_code.constants.end(), [&](const Constant &c) {
      return c.kind == Constant::Kind::RectangleScale && c.index == unit;
    });
  }

  Vec4 sample(const Texture &texture) const {
    const Vec4 &source = m_registers[texture.source];
    const std::uint8_t components = componentsRead(texture);
    ir::Sample request;
    request.target = sampledTarget(texture.target);
    request.unit = texture.unit;
    for (std::size_t i = 0; i < 3; ++i)
      if (components >> i & 1)
        request.coordinate[i] = texture.op == TexOp::Project ? source[i] / source[3] : source[i];
    if (texture.op == TexOp::Bias && (components & 8))
      request.bias = source[3];
    if (request.target == ir::TexTarget::Rect && scalesRectangle(texture.unit)) {
      request.coordinate[0] *= kRectangleWidth;
      request.coordinate[1] *= kRectangleHeight;
    }
    Vec4 texel = m_inputs.texture ? m_inputs.texture(request) : Vec4{};
    if (request.target != texture.target)
      texel.fill(texel[0]);
    for (float &component : texel)
      component = ir::held(component, m_numerics);
    return texel;
  }

  /// Runs the samples of a node. All sources are read before the first result is written.
  void textures(const Node &node) {
    std::vector<Vec4> results(node.textures);
    for (std::uint32_t i = 0; i < node.textures; ++i) {
      const Texture &texture = m_code.textures[node.firstTexture + i];
      if (texture.op == TexOp::Kill)
        m_evaluation.killed |= ir::kills(m_registers[texture.source]);
      else
        results[i] = sample(texture);
    }
    for (std::uint32_t i = 0; i < node.textures; ++i)
      if (m_code.textures[node.firstTexture + i].op != TexOp::Kill)
        m_registers[m_code.textures[node.firstTexture + i].destination] = results[i];
  }

  Vec4 fetch(const Source &source) const {
    switch (source.bank) {
    case Source::Bank::None:
      break;
    case Source::Bank::Temporary:
      return m_registers[source.index];
    case Source::Bank::Constant:
      return m_constants[source.index];
    }
    return {};
  }

  float arithmetic(Opcode op, float a, float b = 0.0f, float c = 0.0f) const {
    const Operands operands = {Vec4{a, a, a, a}, Vec4{b, b, b, b}, Vec4{c, c, c, c}};
    return ir::apply(op, operands, m_numerics)[0];
  }

  /// Returns the values at the addresses of one half. The fourth value is the presubtract result.
  template <typename Half> std::array<Vec4, 4> gather(const Half &half) const {
    std::array<Vec4, 4> values;
    for (std::size_t i = 0; i < 3; ++i)
      values[i] = fetch(half.sources[i]);
    for (std::size_t c = 0; c < 4; ++c)
      values[kPresubtracted][c] = presubtracted(half.presubtract, values[0][c], values[1][c]);
    return values;
  }

  float presubtracted(Presubtract operation, float s0, float s1) const {
    switch (operation) {
    case Presubtract::None:
      break;
    case Presubtract::OneMinusTwoS0:
      return arithmetic(Opcode::Mad, -2.0f, s0, 1.0f);
    case Presubtract::S1MinusS0:
      return arithmetic(Opcode::Sub, s1, s0);
    case Presubtract::S1PlusS0:
      return arithmetic(Opcode::Add, s1, s0);
    case Presubtract::OneMinusS0:
      return arithmetic(Opcode::Sub, 1.0f, s0);
    }
    return 0.0f;
  }

  struct Sources {
    std::array<Vec4, 4> rgb, alpha;
  };

  template <typename Argument>
  static float taken(const Sources &sources, const Argument &argument, const Tap &tap) {
    float value = 0.0f;
    switch (tap.from) {
    case Tap::From::Rgb:
      value = sources.rgb[argument.source][tap.component];
      break;
    case Tap::From::Alpha:
      value = sources.alpha[argument.source][tap.component];
      break;
    case Tap::From::Zero:
      break;
    case Tap::From::One:
      value = 1.0f;
      break;
    case Tap::From::Half:
      value = 0.5f;
      break;
    }
    if (argument.absolute)
      value = std::fabs(value);
    return argument.negate ? -value : value;
  }

  /// Returns the arguments, with those of the RGB half in xyz and those of the alpha half in w.
  static Operands operandsOf(const Pair &pair, const Sources &sources) {
    Operands operands = {};
    for (std::size_t i = 0; i < 3; ++i) {
      const RgbArgument &rgb = pair.rgb.arguments[i];
      for (std::size_t c = 0; c < 3; ++c)
        operands[i][c] = taken(sources, rgb, tapOf(rgb.select, c));
      const AlphaArgument &alpha = pair.alpha.arguments[i];
      operands[i][3] = taken(sources, alpha, tapOf(alpha.select));
    }
    return operands;
  }

  static Vec4 condition(const Operands &operands) {
    Vec4 result;
    for (std::size_t c = 0; c < 4; ++c)
      result[c] = operands[2][c] > 0.5f ? operands[0][c] : operands[1][c];
    return result;
  }

  Vec4 apply(Opcode op, const Operands &operands) const {
    return ir::apply(op, operands, m_numerics);
  }

  /// The operands are reversed because the chip selects by C.
  Vec4 compare(const Operands &o) const { return apply(Opcode::Cmp, {o[2], o[1], o[0]}); }

  /// Returns the result before modifier and clamp. The caller handles ReplAlpha.
  Color rgbResult(RgbOp op, const Operands &operands) const {
    Vec4 result = {};
    switch (op) {
    case RgbOp::None:
    case RgbOp::ReplAlpha:
      break;
    case RgbOp::Mad:
      result = apply(Opcode::Mad, operands);
      break;
    case RgbOp::Dp3:
      result = apply(Opcode::Dp3, operands);
      break;
    case RgbOp::Dp4:
      result = apply(Opcode::Dp4, operands);
      break;
    case RgbOp::Min:
      result = apply(Opcode::Min, operands);
      break;
    case RgbOp::Max:
      result = apply(Opcode::Max, operands);
      break;
    case RgbOp::Cnd:
      result = condition(operands);
      break;
    case RgbOp::Cmp:
      result = compare(operands);
      break;
    case RgbOp::Frc:
      result = apply(Opcode::Frc, operands);
      break;
    }
    return {result[0], result[1], result[2]};
  }

  float alphaResult(AlphaOp op, const Operands &operands, const Color &rgb) const {
    const float a = operands[0][3];
    switch (op) {
    case AlphaOp::None:
      break;
    case AlphaOp::Dp:
      return rgb[0];
    case AlphaOp::Mad:
      return apply(Opcode::Mad, operands)[3];
    case AlphaOp::Min:
      return apply(Opcode::Min, operands)[3];
    case AlphaOp::Max:
      return apply(Opcode::Max, operands)[3];
    case AlphaOp::Cnd:
      return condition(operands)[3];
    case AlphaOp::Cmp:
      return compare(operands)[3];
    case AlphaOp::Frc:
      return apply(Opcode::Frc, operands)[3];
    case AlphaOp::Ex2:
      return arithmetic(Opcode::Ex2, a);
    case AlphaOp::Lg2:
      return arithmetic(Opcode::Lg2, a);
    case AlphaOp::Rcp:
      return arithmetic(Opcode::Rcp, a);
    case AlphaOp::Rsq:
      return arithmetic(Opcode::Rsq, a);
    }
    return 0.0f;
  }

  void step(const Pair &pair) {
    const Sources sources = {gather(pair.rgb), gather(pair.alpha)};
    const Operands operands = operandsOf(pair, sources);
    Color rgb = rgbResult(pair.rgb.op, operands);
    const float alpha = alphaResult(pair.alpha.op, operands, rgb);
    if (pair.rgb.op == RgbOp::ReplAlpha)
      rgb.fill(alpha);
    for (std::size_t c = 0; c < 3; ++c)
      write(pair.rgb, c, finished(pair.rgb, rgb[c]));
    write(pair.alpha, 3, finished(pair.alpha, alpha));
    if (pair.alpha.depth)
      m_evaluation.depth = finished(pair.alpha, alpha);
  }

  template <typename Half> void write(const Half &half, std::size_t component, float value) {
    if (half.mask >> component & 1)
      m_registers[half.temporary][component] = value;
    if (half.outputMask >> component & 1)
      for (std::size_t o = 0; o < m_program.outputs.size(); ++o)
        if (m_program.outputs[o].kind == ir::OutputKind::Color &&
            m_program.outputs[o].index == half.output)
          m_evaluation.outputs[o][component] = value;
  }

  const Code &m_code;
  const ir::Program &m_program;
  const ir::Inputs &m_inputs;
  Numerics m_numerics;
  std::vector<Vec4> m_registers, m_constants;
  ir::Evaluation m_evaluation;
};
} // namespace

ir::Evaluation execute(const Code &code, const ir::Program &program, const ir::Inputs &inputs) {
  return Machine(code, program, inputs).run();
}

} // namespace arbiter::fp::hw::r300
