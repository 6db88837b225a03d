#include "state/raster_draw/fixed_function/fixed_fragment.h"

#include <algorithm>

#include "fp_compiler/ir/builder.h"

namespace arbiter::state {

namespace {

using fp::ir::Opcode;

/// Writes the program of one key. A temporary carries the colour from unit to unit.
class Writer {
public:
  explicit Writer(const FixedFragmentKey &key) : m_key(key) {}

  fp::ir::Program write() {
    m_color = m_builder.temporary("color");
    m_primary = m_builder.attribute(fp::ir::AttributeKind::ColorPrimary);
    m_builder.op(Opcode::Mov, m_color, {m_primary});
    sampleAll();
    for (std::size_t unit = 0; unit < m_key.units.size(); ++unit)
      if (m_key.units[unit].environment != Environment::Off)
        apply(int(unit));
    m_builder.op(Opcode::Mov, m_builder.color(), {m_color.read()});
    m_builder.options().fog = m_key.fog;
    m_builder.options().colorSum = m_key.colorSum != 0;
    m_builder.options().shadow =
        std::any_of(m_key.units.begin(), m_key.units.end(), [](const TextureUnitKey &unit) {
          return unit.target >= fp::ir::TexTarget::Shadow1D;
        });
    return m_builder.take();
  }

private:
  /// Samples all units first: COMBINE may read texels of later units (ARB_texture_env_crossbar).
  void sampleAll() {
    for (std::size_t unit = 0; unit < m_key.units.size(); ++unit) {
      const TextureUnitKey &key = m_key.units[unit];
      if (key.environment == Environment::Off)
        continue;
      m_texels[unit] = m_builder.temporary();
      m_builder.tex(Opcode::Txp, m_texels[unit],
                    m_builder.attribute(fp::ir::AttributeKind::TexCoord, int(unit)), int(unit),
                    key.target);
    }
  }

  [[nodiscard]] fp::ir::Source constant(int unit) {
    fp::ir::StateRef ref;
    ref.item = fp::ir::StateItem::TexEnvColor;
    ref.index = std::uint8_t(unit);
    return m_builder.state(ref);
  }

  void apply(int unit) {
    const TextureUnitKey &key = m_key.units[std::size_t(unit)];
    const fp::ir::Source texel = m_texels[std::size_t(unit)].read();
    switch (key.environment) {
    case Environment::Off:
      return;
    case Environment::Replace:
      return replace(key.kind, texel);
    case Environment::Modulate:
      return modulate(key.kind, texel);
    case Environment::Decal:
      m_builder.op(Opcode::Lrp, m_color.mask("xyz"),
                   {key.kind == TexelKind::Opaque ? m_builder.constant(1.0f) : texel.swz("w"),
                    texel, m_color.read()});
      return;
    case Environment::Blend:
      return blend(key.kind, texel, constant(unit));
    case Environment::Add:
      return add(key.kind, texel);
    case Environment::Combine:
      return combine(unit, key);
    }
  }

  void replace(TexelKind kind, const fp::ir::Source &texel) {
    if (kind != TexelKind::Alpha)
      m_builder.op(Opcode::Mov, m_color.mask("xyz"), {texel});
    if (kind != TexelKind::Opaque)
      m_builder.op(Opcode::Mov, m_color.mask("w"), {texel});
  }

  void modulate(TexelKind kind, const fp::ir::Source &texel) {
    m_builder.op(Opcode::Mul, kind == TexelKind::Alpha ? m_color.mask("w") : m_color,
                 {m_color.read(), texel});
  }

  void blend(TexelKind kind, const fp::ir::Source &texel, const fp::ir::Source &constantColor) {
    if (kind != TexelKind::Alpha)
      m_builder.op(Opcode::Lrp, m_color.mask("xyz"), {texel, constantColor, m_color.read()});
    if (kind == TexelKind::Intensity)
      m_builder.op(Opcode::Lrp, m_color.mask("w"), {texel, constantColor, m_color.read()});
    else if (kind != TexelKind::Opaque)
      m_builder.op(Opcode::Mul, m_color.mask("w"), {m_color.read(), texel});
  }

  void add(TexelKind kind, const fp::ir::Source &texel) {
    if (kind != TexelKind::Alpha)
      m_builder.op(Opcode::Add, m_color.mask("xyz").sat(), {m_color.read(), texel});
    if (kind == TexelKind::Intensity)
      m_builder.op(Opcode::Add, m_color.mask("w").sat(), {m_color.read(), texel});
    else if (kind != TexelKind::Opaque)
      m_builder.op(Opcode::Mul, m_color.mask("w"), {m_color.read(), texel});
  }

  [[nodiscard]] fp::ir::Source argument(int unit, const Combiner &half, int i) {
    const auto at = std::size_t(i);
    fp::ir::Source source = m_color.read();
    switch (half.sources[at]) {
    case 0:
      source = m_texels[std::size_t(unit)].read();
      break;
    case 1:
      source = constant(unit);
      break;
    case 2:
      source = m_primary;
      break;
    case 3:
      break;
    default:
      source = m_texels[std::size_t(half.sources[at] - 4)].read();
    }
    if ((half.operands[at] & 2) != 0)
      source = source.swz("w");
    if ((half.operands[at] & 1) == 0)
      return source;
    const fp::ir::Target complement = m_builder.temporary();
    m_builder.op(Opcode::Sub, complement, {m_builder.constant(1.0f), source});
    return complement.read();
  }

  /// Writes one half of COMBINE (table 3.24), before the scale, to a temporary through its mask.
  void function(int unit, const Combiner &half, const fp::ir::Target &to) {
    const auto arg = [&](int i) { return argument(unit, half, i); };
    const fp::ir::Target work = m_builder.temporary();
    switch (half.function) {
    case 0: // REPLACE
      m_builder.op(Opcode::Mov, to, {arg(0)});
      return;
    case 1: // MODULATE
      m_builder.op(Opcode::Mul, to, {arg(0), arg(1)});
      return;
    case 2: // ADD
      m_builder.op(Opcode::Add, to, {arg(0), arg(1)});
      return;
    case 3: // ADD_SIGNED
      m_builder.op(Opcode::Add, work, {arg(0), arg(1)});
      m_builder.op(Opcode::Sub, to, {work.read(), m_builder.constant(0.5f)});
      return;
    case 4: // INTERPOLATE
      m_builder.op(Opcode::Lrp, to, {arg(2), arg(0), arg(1)});
      return;
    case 5: // SUBTRACT
      m_builder.op(Opcode::Sub, to, {arg(0), arg(1)});
      return;
    default: { // DOT3_RGB, DOT3_RGBA: 4 * (a - 1/2) . (b - 1/2)
      const fp::ir::Target other = m_builder.temporary();
      const fp::ir::Source middle = m_builder.constant(0.5f), four = m_builder.constant(4.0f);
      m_builder.op(Opcode::Sub, work, {arg(0), middle});
      m_builder.op(Opcode::Sub, other, {arg(1), middle});
      m_builder.op(Opcode::Dp3, work, {work.read(), other.read()});
      m_builder.op(Opcode::Mul, to, {work.read(), four});
    }
    }
  }

  void combine(int unit, const TextureUnitKey &key) {
    const fp::ir::Target result = m_builder.temporary();
    const bool dotRgba = key.color.function == 7;
    function(unit, key.color, dotRgba ? result : result.mask("xyz"));
    if (!dotRgba)
      function(unit, key.alpha, result.mask("w"));
    const auto scale = [](const Combiner &half) { return float(half.scale); };
    // Applies to DOT3_RGBA too (ARB_texture_env_dot3, issue 2), as in Mesa. NVIDIA's driver scales
    // its alpha like RGB.
    const float rgb = scale(key.color), alpha = scale(key.alpha);
    m_builder.op(Opcode::Mul, m_color.sat(),
                 {result.read(), m_builder.constant(rgb, rgb, rgb, alpha)});
  }

  const FixedFragmentKey &m_key;
  fp::ir::Builder m_builder;
  fp::ir::Target m_color;
  fp::ir::Source m_primary;
  std::array<fp::ir::Target, 8> m_texels;
};

} // namespace

fp::ir::Program makeFixedFragmentProgram(const FixedFragmentKey &key) {
  return Writer(key).write();
}

} // namespace arbiter::state
