#include "fp_compiler/combiners/lower.h"

#include <string>
#include <vector>

#include "fp_compiler/combiners/values.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::combiners {

namespace {

using ir::Opcode;
using ir::Source;
using ir::Target;
using ir::TexTarget;

/// The RGB and the alpha half of a register.
struct Contents {
  Value rgb, alpha;
};

float factor(Scale scale) {
  constexpr float kFactors[] = {1.0f, 2.0f, 4.0f, 0.5f};
  return kFactors[std::size_t(scale)];
}

class Lowering {
public:
  /// \param textures gives the initial texture registers. If empty, they are samples of the units'
  /// targets.
  Lowering(ir::Builder &builder, const State &state, const Surroundings &surroundings,
           const InitialTexture &textures)
      : m_state(state), m_around(surroundings), m_textures(textures), m_builder(builder),
        m_values(builder, surroundings.fx9) {}

  void run() {
    for (int i = 0; i < m_state.count; ++i)
      general(i);
    m_stage = -1;
    final();
  }

private:
  // --- Registers ---

  /// Returns one half of a register as it is before the current stage. The initial value is
  /// computed on the first read, so that textures no stage reads are not sampled.
  const Value &read(Register name, Half half) {
    if (name == Register::Constant0 || name == Register::Constant1) {
      const Contents &color = constant(name == Register::Constant0 ? 0 : 1);
      return half == Half::Rgb ? color.rgb : color.alpha;
    }
    std::optional<Value> &known = m_registers[std::size_t(name)][std::size_t(half)];
    if (!known)
      known = initial(name, half);
    return *known;
  }

  const Contents &constant(int which) {
    const bool own = m_state.perStageConstants && m_stage >= 0;
    const int index = own ? stageConstant(m_stage, which) : globalConstant(which);
    std::optional<Contents> &known = m_constants[std::size_t(index)];
    if (!known) {
      const Source color = m_builder.env(index);
      const Value value{color, 0.0f, 1.0f, {}};
      known = {m_values.registered(Half::Rgb, value), m_values.registered(Half::Alpha, value)};
    }
    return *known;
  }

  /// Returns the initial value of a register (table RC.1).
  Value initial(Register name, Half half) {
    const auto attribute = [&](ir::AttributeKind kind) {
      return m_values.registered(half, unknown(m_builder.attribute(kind)));
    };
    switch (name) {
    case Register::Primary:
      return attribute(ir::AttributeKind::ColorPrimary);
    case Register::Secondary:
      return attribute(ir::AttributeKind::ColorSecondary);
    case Register::Fog:
      return m_values.registered(half, half == Half::Rgb ? fogColor() : fogFactor());
    case Register::Spare0:
      return half == Half::Alpha ? texture(0).alpha : m_values.literal(0.0f);
    default:
      break;
    }
    const int unit = textureUnit(name);
    if (unit < 0)
      return m_values.literal(0.0f);
    return half == Half::Rgb ? texture(unit).rgb : texture(unit).alpha;
  }

  const Contents &texture(int unit) {
    std::optional<Contents> &known = m_samples[std::size_t(unit)];
    if (!known)
      known = m_textures ? given(m_textures(unit)) : sample(unit);
    return *known;
  }

  static Value unknown(const Source &source) { return {source, -Value::kAny, Value::kAny, {}}; }

  Contents given(const std::optional<Source> &texture) {
    if (!texture)
      return {m_values.literal(0.0f), m_values.literal(0.0f)};
    return {m_values.registered(Half::Rgb, unknown(*texture)),
            m_values.registered(Half::Alpha, unknown(texture->swz("w")))};
  }

  /// Returns the initial value of a texture register: a sample with conventional texturing (table
  /// RC.2).
  Contents sample(int unit) {
    const Texel texel = m_around.texels[std::size_t(unit)];
    if (texel == Texel::None)
      return given({});
    const TexTarget target = m_around.targets[std::size_t(unit)];
    const bool compares = ir::isShadow(target);
    if (compares)
      m_builder.options().shadow = true;
    const Target to = m_builder.temporary("texture" + std::to_string(unit));
    m_builder.tex(target == TexTarget::Cube ? Opcode::Tex : Opcode::Txp, to,
                  m_builder.attribute(ir::AttributeKind::TexCoord, unit), unit, target);
    if (texel == Texel::Color)
      return given(to.read());
    const Source depth = to.read().swz(texel == Texel::DepthInAlpha ? "w" : "x");
    Contents result = given(depth);
    if (!compares)
      result.rgb = m_values.literal(0.0f);
    return result;
  }

  Value fogColor() { return unknown(m_builder.state({.item = ir::StateItem::FogColor})); }

  /// Returns the fog factor (OpenGL 1.4, section 3.10), or one if fog is disabled. It reads the
  /// state that ARB texts can name, because hosts may get the program as one. The parameters are
  /// the density, start, end and 1 / (end - start).
  Value fogFactor() {
    if (m_around.fog == ir::FogMode::None)
      return m_values.literal(1.0f);
    const Source parameters = m_builder.state({.item = ir::StateItem::FogParams});
    const Source distance = m_builder.attribute(ir::AttributeKind::FogCoord).swz("x");
    const Target to = m_builder.temporary("fog").mask("w");
    const Source so = to.read().swz("w");
    if (m_around.fog == ir::FogMode::Linear) {
      m_builder.op(Opcode::Sub, to, {parameters.swz("z"), distance});
      m_builder.op(Opcode::Mul, to.sat(), {so, parameters.swz("w")});
    } else {
      constexpr float kLog2E = 1.44269504f;
      m_builder.op(Opcode::Mul, to, {parameters.swz("x"), distance});
      if (m_around.fog == ir::FogMode::Exp2)
        m_builder.op(Opcode::Mul, to, {so, so});
      m_builder.op(Opcode::Mul, to, {so, m_builder.constant(kLog2E)});
      m_builder.op(Opcode::Ex2, to.sat(), {-so});
    }
    return {to.read(), 0.0f, 1.0f, {}};
  }

  // --- Inputs ---

  /// Returns the selected register half of a variable before the mapping.
  Value picked(const Input &input) {
    Value value = read(input.source, input.usage == Usage::Alpha ? Half::Alpha : Half::Rgb);
    if (input.usage != Usage::Rgb) {
      const char *const component = input.usage == Usage::Alpha ? "w" : "z";
      value.source = value.source.swz(component);
      if (value.beneath)
        value.beneath->source = value.beneath->source.swz(component);
    }
    return value;
  }

  Value variable(Half half, const Input &input) {
    return m_values.mapped(half, picked(input), input.mapping);
  }

  // --- General stages (3.8.12.2) ---

  struct Write {
    Register to;
    Half half;
    Value value;
  };

  void general(int i) {
    m_stage = i;
    std::vector<Write> writes; // both portions read the registers as they were before the stage
    portion(m_state.stages[std::size_t(i)].rgb, Half::Rgb, writes);
    portion(m_state.stages[std::size_t(i)].alpha, Half::Alpha, writes);
    for (const Write &write : writes)
      m_registers[std::size_t(write.to)][std::size_t(write.half)] = write.value;
  }

  /// Computes one portion of a stage. RC's equations have no sum of dot products, but its issues
  /// do. A dot product is clamped before it enters the sum or the mux, and scaled before it is
  /// output as a product. NVIDIA's driver did this in each of 1,594 random states.
  void portion(const Portion &portion, Half half, std::vector<Write> &writes) {
    const auto write = [&](Register to, const Value &computed) {
      if (to != Register::Discard)
        writes.push_back({to, half, output(computed, half, portion)});
    };
    const bool sums = portion.sum != Register::Discard;
    const bool needsAb = portion.ab != Register::Discard;
    if (!sums && !needsAb && portion.cd == Register::Discard)
      return;
    const auto in = [&](std::size_t v) { return variable(half, portion.inputs[v]); };
    if (sums && !needsAb && !portion.abDot && !portion.mux) { // the most common case: one MAD
      Value cd = product(half, in(2), in(3), portion.cdDot);
      write(portion.cd, cd);
      if (portion.cdDot)
        cd = clamped(half, cd, m_values.oneOfProduct());
      return write(portion.sum, m_values.multiplyAdd(half, in(0), in(1), cd));
    }
    Value ab = sums || needsAb ? product(half, in(0), in(1), portion.abDot) : Value{};
    write(portion.ab, ab);
    Value cd = sums || portion.cd != Register::Discard ? product(half, in(2), in(3), portion.cdDot)
                                                       : Value{};
    write(portion.cd, cd);
    if (!sums)
      return;
    if (portion.abDot)
      ab = clamped(half, ab, m_values.oneOfProduct());
    if (portion.cdDot)
      cd = clamped(half, cd, m_values.oneOfProduct());
    write(portion.sum, portion.mux
                           ? m_values.chosen(half, read(Register::Spare0, Half::Alpha), ab, cd)
                           : m_values.sum(half, ab, cd));
  }

  Value product(Half half, const Value &a, const Value &b, bool dot) {
    return dot ? m_values.dot(a, b) : m_values.product(half, a, b);
  }

  /// \param one the representation of one at this point (Values::one() or Values::oneOfProduct())
  Value clamped(Half half, const Value &value, float one) {
    return m_values.clamped(half, value, -one, one);
  }

  Value output(const Value &computed, Half half, const Portion &portion) {
    return clamped(half, m_values.fromProduct(half, computed, factor(portion.scale), portion.bias),
                   m_values.one());
  }

  // --- The final combiner (3.8.12.3) ---

  bool isFinalInput(Register name) const {
    for (std::size_t v = 0; v < 4; ++v)
      if (m_state.finals[v].source == name)
        return true;
    return false;
  }

  void final() {
    if (isFinalInput(Register::ETimesF))
      m_product =
          m_values.fromProduct(Half::Rgb,
                               m_values.product(Half::Rgb, variable(Half::Rgb, m_state.finals[4]),
                                                variable(Half::Rgb, m_state.finals[5])),
                               1.0f, false);
    if (isFinalInput(Register::Spare0PlusSecondary))
      m_sum = colorSum();
    const Value a = finalVariable(0), b = finalVariable(1), c = finalVariable(2),
                d = finalVariable(3);
    const Value added = m_values.product(Half::Rgb, d, m_values.literal(m_values.one()));
    const Value computed = m_values.fromProduct(
        Half::Rgb, m_values.sum(Half::Rgb, m_values.blended(Half::Rgb, a, b, c), added), 1.0f,
        false);
    const Value color =
        m_values.given(Half::Rgb, m_values.atMost(Half::Rgb, computed, m_values.one()));
    m_builder.op(Opcode::Mov, m_builder.color().mask("xyz"), {color.source});
    const Value alpha = m_values.given(Half::Alpha, variable(Half::Alpha, m_state.finals[6]));
    m_builder.op(Opcode::Mov, m_builder.color().mask("w"), {alpha.source});
  }

  Value colorSum() {
    const auto positive = [&](Register name) {
      return m_values.atLeast(Half::Rgb, read(name, Half::Rgb), 0.0f);
    };
    const Value sum =
        m_values.sum(Half::Rgb, positive(Register::Spare0), positive(Register::Secondary));
    return m_state.sumClamp ? m_values.atMost(Half::Rgb, sum, m_values.one()) : sum;
  }

  /// Returns variable A to D. Their sources include the pseudo-registers, which have an alpha of
  /// zero.
  Value finalVariable(std::size_t v) {
    const Input &input = m_state.finals[v];
    if (input.source != Register::ETimesF && input.source != Register::Spare0PlusSecondary)
      return variable(Half::Rgb, input);
    const Value &color = input.source == Register::ETimesF ? m_product : m_sum;
    return m_values.mapped(Half::Rgb, input.usage == Usage::Rgb ? color : m_values.literal(0.0f),
                           input.mapping);
  }

  const State &m_state;
  const Surroundings &m_around;
  const InitialTexture &m_textures;
  ir::Builder &m_builder;
  Values m_values;
  int m_stage = 0; ///< -1 in the final combiner
  std::array<std::array<std::optional<Value>, 2>, kRegisters> m_registers;
  std::array<std::optional<Contents>, kTextures> m_samples;
  std::array<std::optional<Contents>, kConstants> m_constants;
  Value m_product, m_sum; ///< pseudo-registers of the final combiner
};

} // namespace

ir::Program lower(const State &state, const Surroundings &surroundings) {
  ir::Builder builder;
  lower(builder, state, surroundings, {});
  return builder.take();
}

void lower(ir::Builder &builder, const State &state, const Surroundings &surroundings,
           const InitialTexture &textures) {
  Lowering(builder, state, surroundings, textures).run();
}

} // namespace arbiter::fp::combiners
