#include "fp_compiler/texture_shader/environment.h"

namespace arbiter::fp::texture_shader {

namespace {

using ir::Opcode;
using ir::Source;
using ir::Target;

constexpr int kArguments[] = {1, 2, 2, 2, 3, 2, 2, 2, 3, 3, 3, 4, 4, 0};

/// Emits the code of texture environments. A temporary holds the colour from unit to unit.
class Writer {
public:
  Writer(ir::Builder &builder, const UnitColor &texel) : m_builder(builder), m_texel(texel) {
    m_color = m_builder.temporary("color");
    m_primary = m_builder.attribute(ir::AttributeKind::ColorPrimary);
    m_builder.op(Opcode::Mov, m_color, {m_primary});
  }

  void apply(int unit, const Environment &environment, Base base) {
    switch (environment.mode) {
    case EnvironmentMode::None:
      return;
    case EnvironmentMode::Replace:
      return replace(base, m_texel(unit));
    case EnvironmentMode::Modulate:
      return modulate(base, m_texel(unit));
    case EnvironmentMode::Decal:
      return decal(base, m_texel(unit));
    case EnvironmentMode::Blend:
      return blend(base, m_texel(unit), constant(unit));
    case EnvironmentMode::Add:
      return add(base, m_texel(unit));
    case EnvironmentMode::Combine:
      return combine(unit, environment);
    }
  }

  [[nodiscard]] Source color() const { return m_color.read(); }

private:
  static bool hasColor(Base base) { return base != Base::Alpha; }
  static bool hasAlpha(Base base) { return base != Base::Luminance && base != Base::Rgb; }

  Source constant(int unit) {
    ir::StateRef ref;
    ref.item = ir::StateItem::TexEnvColor;
    ref.index = std::uint8_t(unit);
    return m_builder.state(ref);
  }
  Source notNegative(const Source &source) {
    const Target to = m_builder.temporary();
    m_builder.op(Opcode::Max, to, {source, m_builder.constant(0.0f)});
    return to.read();
  }

  void replace(Base base, const Source &texel) {
    if (hasColor(base))
      m_builder.op(Opcode::Mov, m_color.mask("xyz"), {texel});
    if (hasAlpha(base))
      m_builder.op(Opcode::Mov, m_color.mask("w"), {texel});
  }

  void modulate(Base base, const Source &texel) {
    if (hasColor(base))
      m_builder.op(Opcode::Mul, m_color.mask("xyz"), {m_color.read(), texel});
    if (hasAlpha(base))
      m_builder.op(Opcode::Mul, m_color.mask("w"), {m_color.read(), texel});
  }

  /// Emits DECAL for RGB and RGBA. Other formats leave the colour unchanged (table 3.18 as
  /// amended).
  void decal(Base base, const Source &texel) {
    if (base == Base::Rgb)
      m_builder.op(Opcode::Mov, m_color.mask("xyz"), {texel});
    else if (base == Base::Rgba)
      m_builder.op(Opcode::Lrp, m_color.mask("xyz"),
                   {notNegative(texel).swz("w"), texel, m_color.read()});
  }

  void blend(Base base, const Source &texel, const Source &constantColor) {
    const Source weight = notNegative(texel);
    if (hasColor(base))
      m_builder.op(Opcode::Lrp, m_color.mask("xyz"), {weight, constantColor, m_color.read()});
    if (base == Base::Intensity || base == Base::DsdtMagIntensity)
      m_builder.op(Opcode::Lrp, m_color.mask("w"), {weight, constantColor, m_color.read()});
    else if (hasAlpha(base))
      m_builder.op(Opcode::Mul, m_color.mask("w"), {m_color.read(), texel});
  }

  void addTo(const char *mask, const Source &texel) {
    const Target to = m_color.mask(mask);
    m_builder.op(Opcode::Add, to, {m_color.read(), texel});
    m_builder.op(Opcode::Min, to, {m_color.read(), m_builder.constant(1.0f)});
    m_builder.op(Opcode::Max, to, {m_color.read(), m_builder.constant(-1.0f)});
  }
  void add(Base base, const Source &texel) {
    if (hasColor(base))
      addTo("xyz", texel);
    if (base == Base::Intensity || base == Base::DsdtMagIntensity)
      addTo("w", texel);
    else if (hasAlpha(base))
      m_builder.op(Opcode::Mul, m_color.mask("w"), {m_color.read(), texel});
  }

  /// Returns an argument of COMBINE (tables 3.21 and 3.22), clamped as amended.
  Source argument(int unit, const CombineArgument &argument) {
    Source source;
    switch (argument.source) {
    case CombineSource::Texture:
      source = m_texel(unit);
      break;
    case CombineSource::Constant:
      source = constant(unit);
      break;
    case CombineSource::Primary:
      source = m_primary;
      break;
    case CombineSource::Previous:
      source = m_color.read();
      break;
    case CombineSource::Zero:
      source = m_builder.constant(0.0f);
      break;
    case CombineSource::One:
      source = m_builder.constant(1.0f);
      break;
    default:
      source = m_texel(int(argument.source) - int(CombineSource::Unit0));
    }
    source = notNegative(source);
    if (argument.alpha)
      source = source.swz("w");
    if (!argument.complement)
      return source;
    const Target complement = m_builder.temporary();
    m_builder.op(Opcode::Sub, complement, {m_builder.constant(1.0f), source});
    return complement.read();
  }

  void sum(const Target &to, const Source &a, const Source &b, const Source &c, const Source &d,
           bool isSigned) {
    const Target product = m_builder.temporary();
    m_builder.op(Opcode::Mul, product, {c, d});
    m_builder.op(Opcode::Mad, isSigned ? product : to, {a, b, product.read()});
    if (isSigned)
      m_builder.op(Opcode::Sub, to, {product.read(), m_builder.constant(0.5f)});
  }

  void dot(const Target &to, const Source &a, const Source &b) {
    const Target left = m_builder.temporary(), right = m_builder.temporary();
    const Source middle = m_builder.constant(0.5f);
    m_builder.op(Opcode::Sub, left, {a, middle});
    m_builder.op(Opcode::Sub, right, {b, middle});
    m_builder.op(Opcode::Dp3, left, {left.read(), right.read()});
    m_builder.op(Opcode::Mul, to, {left.read(), m_builder.constant(4.0f)});
  }

  /// Emits one half of COMBINE before the scale.
  void function(int unit, const CombineHalf &half, const Target &to) {
    std::array<Source, 4> a;
    for (int i = 0; i < argumentsOf(half.function); ++i)
      a[std::size_t(i)] = argument(unit, half.arguments[std::size_t(i)]);
    const Source one = m_builder.constant(1.0f);
    switch (half.function) {
    case CombineFunction::Replace:
      m_builder.op(Opcode::Mov, to, {a[0]});
      return;
    case CombineFunction::Modulate:
      m_builder.op(Opcode::Mul, to, {a[0], a[1]});
      return;
    case CombineFunction::Add:
      m_builder.op(Opcode::Add, to, {a[0], a[1]});
      return;
    case CombineFunction::AddSigned:
      return sum(to, a[0], one, a[1], one, true);
    case CombineFunction::Interpolate:
      m_builder.op(Opcode::Lrp, to, {a[2], a[0], a[1]});
      return;
    case CombineFunction::Subtract:
      m_builder.op(Opcode::Sub, to, {a[0], a[1]});
      return;
    case CombineFunction::Dot3Rgb:
    case CombineFunction::Dot3Rgba:
      return dot(to, a[0], a[1]);
    case CombineFunction::ModulateAdd:
      return sum(to, a[0], a[2], a[1], one, false);
    case CombineFunction::ModulateSignedAdd:
      return sum(to, a[0], a[2], a[1], one, true);
    case CombineFunction::ModulateSubtract:
      return sum(to, a[0], a[2], -a[1], one, false);
    case CombineFunction::AddProducts:
      return sum(to, a[0], a[1], a[2], a[3], false);
    case CombineFunction::AddSignedProducts:
      return sum(to, a[0], a[1], a[2], a[3], true);
    case CombineFunction::BumpEnvmap:
      return; // combine() passes the colour on
    }
  }

  void combine(int unit, const Environment &environment) {
    const Target result = m_builder.temporary();
    const bool dotRgba = environment.color.function == CombineFunction::Dot3Rgba;
    if (environment.color.function != CombineFunction::BumpEnvmap)
      function(unit, environment.color, dotRgba ? result : result.mask("xyz"));
    if (!dotRgba)
      function(unit, environment.alpha, result.mask("w"));
    const auto rgb = float(environment.color.scale);
    if (environment.color.function == CombineFunction::BumpEnvmap) {
      m_builder.op(Opcode::Mul, m_color.mask("w").sat(),
                   {result.read(), m_builder.constant(float(environment.alpha.scale))});
      return;
    }
    // This follows NVIDIA's driver, because the extensions come from NVIDIA. Fixed function without
    // them follows Mesa, which applies ALPHA_SCALE here too. The specification allows both
    // (ARB_texture_env_dot3, issue 2).
    const float alpha = dotRgba ? rgb : float(environment.alpha.scale);
    m_builder.op(Opcode::Mul, m_color.sat(),
                 {result.read(), m_builder.constant(rgb, rgb, rgb, alpha)});
  }

  ir::Builder &m_builder;
  const UnitColor &m_texel;
  Target m_color;
  Source m_primary;
};

} // namespace

int argumentsOf(CombineFunction function) { return kArguments[std::size_t(function)]; }

ir::Source writeEnvironments(ir::Builder &builder, const Environments &environments,
                             const std::array<Base, kUnits> &bases, const UnitColor &texel) {
  Writer writer(builder, texel);
  for (std::size_t unit = 0; unit < environments.size(); ++unit)
    if (isRgba(bases[unit]) || bases[unit] == Base::DsdtMagIntensity)
      writer.apply(int(unit), environments[unit], bases[unit]);
  return writer.color();
}

} // namespace arbiter::fp::texture_shader
