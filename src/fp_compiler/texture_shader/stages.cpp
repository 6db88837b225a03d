#include "fp_compiler/texture_shader/stages.h"

#include <string>

namespace arbiter::fp::texture_shader {

using ir::Opcode;
using ir::Source;
using ir::Target;

std::optional<Source> Stages::color(int unit) {
  const Base base = environmentBase(unit);
  if (base == Base::None)
    return std::nullopt;
  if (base == Base::DsdtMagIntensity)
    return result(unit).swz("w");
  if (resultOf(m_state, unit).base == Base::Dudv)
    return m_builder.constant(0, 0, 0, 1); // table 3.23 of ATI_envmap_bumpmap
  return info(unit).scale ? scaled(unit) : result(unit);
}

Base Stages::environmentBase(int unit) const {
  const Base base = resultOf(m_state, unit).base;
  if (base == Base::Dudv)
    return Base::Rgb;
  return isRgba(base) || base == Base::DsdtMagIntensity ? base : Base::None;
}

void Stages::finish() {
  for (int unit = 0; unit < m_state.units; ++unit)
    if (info(unit).family == Family::Cull)
      cull(unit);
    else if (info(unit).family == Family::DotDepth)
      replaceDepth(unit);
}

Source Stages::result(int unit) {
  std::optional<Source> &known = m_results[std::size_t(unit)];
  if (!known)
    known = shade(unit);
  return *known;
}

Source Stages::shade(int unit) {
  switch (info(unit).family) {
  case Family::Texture:
    if (bumping(unit) != 0)
      return sample(unit, Opcode::Tex, bumped(unit));
    return sample(unit, info(unit).target == ir::TexTarget::Cube ? Opcode::Tex : Opcode::Txp,
                  coordinates(unit));
  case Family::PassThrough: {
    const Target to = m_builder.temporary();
    m_builder.op(Opcode::Mov, to.sat(), {coordinates(unit)});
    return to.read();
  }
  case Family::Offset:
    return sample(unit, Opcode::Tex, moved(unit));
  case Family::Dependent:
    return sample(unit, Opcode::Tex, dependent(unit));
  case Family::DotSample:
    return sample(unit, Opcode::Tex, products(unit - info(unit).dots + 1, info(unit).dots));
  case Family::Reflect:
    return sample(unit, Opcode::Tex, reflected(unit));
  case Family::Diffuse:
    return sample(unit, Opcode::Tex, products(unit - 1, 3));
  case Family::DotColor: {
    const Target to = m_builder.temporary();
    m_builder.op(Opcode::Mov, to.sat(), {dot(unit)});
    return to.read();
  }
  default:
    return m_builder.constant(0.0f);
  }
}

/// Samples a texture and adjusts components to their ranges (table 3.E).
Source Stages::sample(int unit, Opcode opcode, const Source &at) {
  const Texture &texture = m_state.textures[std::size_t(unit)];
  ir::TexTarget target = *info(unit).target;
  if (texture.compares) {
    target = target == ir::TexTarget::Tex1D   ? ir::TexTarget::Shadow1D
             : target == ir::TexTarget::Tex2D ? ir::TexTarget::Shadow2D
                                              : ir::TexTarget::ShadowRect;
    m_builder.options().shadow = true;
  }
  const Target texel = m_builder.temporary("texture" + std::to_string(unit));
  m_builder.tex(opcode, texel, at, unit, target);
  if (texture.base == Base::Alpha && !m_state.conventional)
    m_builder.op(Opcode::Mov, texel.mask("xyz"), {m_builder.constant(1.0f)});
  if (texture.signs == Signs::SignedRgb)
    m_builder.op(Opcode::Max, texel.mask("w"), {texel.read(), m_builder.constant(0.0f)});
  return texel.read();
}

/// Returns the offset coordinates (s', t') (3.8.13.1.8).
Source Stages::moved(int unit) {
  const Source previous = result(stage(unit).previous);
  const Source matrix = m_builder.env(parameter(unit, Row::Matrix));
  const Target at = m_builder.temporary();
  Source from = coordinates(unit);
  if (info(unit).projective) {
    const Target inverse = m_builder.temporary();
    m_builder.op(Opcode::Rcp, inverse.mask("w"), {from.swz("w")});
    m_builder.op(Opcode::Mul, at.mask("xy"), {from, inverse.read().swz("w")});
    from = at.read();
  }
  m_builder.op(Opcode::Mad, at.mask("xy"), {matrix.swz("xyxy"), previous.swz("x"), from});
  m_builder.op(Opcode::Mad, at.mask("xy"), {matrix.swz("zwzw"), previous.swz("y"), at.read()});
  return at.read().swz("xyxy");
}

/// Returns the units whose texels are added to the unit's coordinates. For a bumping unit these are
/// units before it; for other units, all.
std::uint32_t Stages::bumping(int unit) const {
  const bool bumps = m_state.bumps[std::size_t(unit)] != 0;
  std::uint32_t units = 0;
  for (int from = 0; from < (bumps ? unit : int(m_state.units)); ++from)
    if (m_state.bumps[std::size_t(from)] == unit + 1 && from != unit &&
        resultOf(m_state, from).base == Base::Dudv)
      units |= 1u << unsigned(from);
  return units;
}

/// Returns the divided coordinates with offsets: u + du', v + dv' (ATI_envmap_bumpmap, section
/// 3.8.11).
Source Stages::bumped(int unit) {
  const Target at = m_builder.temporary();
  const Source from = coordinates(unit);
  if (info(unit).target == ir::TexTarget::Cube) {
    m_builder.op(Opcode::Mov, at, {from});
  } else {
    const Target inverse = m_builder.temporary();
    m_builder.op(Opcode::Rcp, inverse.mask("w"), {from.swz("w")});
    m_builder.op(Opcode::Mul, at, {from, inverse.read().swz("w")});
  }
  const std::uint32_t units = bumping(unit);
  for (int bump = 0; bump < m_state.units; ++bump) {
    if ((units >> unsigned(bump) & 1u) == 0)
      continue;
    const Source texel = result(bump), matrix = m_builder.env(parameter(bump, Row::Bump));
    m_builder.op(Opcode::Mad, at.mask("xy"), {matrix.swz("xzxz"), texel.swz("x"), at.read()});
    m_builder.op(Opcode::Mad, at.mask("xy"), {matrix.swz("ywyw"), texel.swz("y"), at.read()});
  }
  return at.read().swz("xyzz");
}

Source Stages::dependent(int unit) {
  const int read = stage(unit).previous;
  const Source previous = result(read);
  switch (stage(unit).operation) {
  case Operation::DependentAR2D:
    return previous.swz("wxxx");
  case Operation::DependentGB2D:
    return previous.swz("yzzz");
  case Operation::DependentHilo2D:
    return previous.swz("xyyy");
  case Operation::DependentRgbCubeMap:
    if (resultOf(m_state, read).signs == Signs::Unsigned) {
      const Target at = m_builder.temporary();
      m_builder.op(Opcode::Mad, at.mask("xyz"),
                   {previous, m_builder.constant(2.0f), m_builder.constant(-1.0f)});
      return at.read().swz("xyzz");
    }
    [[fallthrough]];
  default:
    return previous.swz("xyzz");
  }
}

Source Stages::dot(int unit) {
  std::optional<Source> &known = m_dots[std::size_t(unit)];
  if (!known)
    known = product(unit);
  return *known;
}

/// Computes the dot product of a stage (3.8.13.1.14), with the mapping of TS3.
Source Stages::product(int unit) {
  const int read = stage(unit).previous;
  const Source previous = result(read), s = coordinates(unit);
  const Texture type = resultOf(m_state, read);
  const Target to = m_builder.temporary("dot" + std::to_string(unit));
  const auto withThird = [&](const Source &third) {
    m_builder.op(Opcode::Mad, to, {s.swz("x"), previous.swz("x"), third});
    m_builder.op(Opcode::Mad, to, {s.swz("y"), previous.swz("y"), to.read()});
  };
  const Mapping mapping = type.signs == Signs::Signed ? Mapping::UnsignedIdentity //
                                                      : stage(unit).mapping;
  if (type.base == Base::Hilo && type.signs == Signs::Signed) {
    // sqrt(max(0, x)) is computed as x * rsq(x). The lower bound avoids 0 * infinity.
    const Target third = m_builder.temporary().mask("x");
    const Source x = third.read().swz("x");
    m_builder.op(Opcode::Mad, third,
                 {-previous.swz("x"), previous.swz("x"), m_builder.constant(1.0f)});
    m_builder.op(Opcode::Mad, third, {-previous.swz("y"), previous.swz("y"), x});
    m_builder.op(Opcode::Max, third, {x, m_builder.constant(1e-20f)});
    const Target root = m_builder.temporary().mask("x");
    m_builder.op(Opcode::Rsq, root, {x});
    m_builder.op(Opcode::Mul, root, {x, root.read().swz("x")});
    m_builder.op(Opcode::Mul, root, {s.swz("z"), root.read().swz("x")});
    withThird(root.read().swz("x"));
  } else if (type.base == Base::Hilo || mapping == Mapping::ForceBlueToOne) {
    withThird(s.swz("z"));
  } else if (mapping == Mapping::ExpandNormal) {
    const Target wide = m_builder.temporary();
    m_builder.op(Opcode::Mad, wide.mask("xyz"),
                 {previous, m_builder.constant(2.0f), m_builder.constant(-1.0f)});
    m_builder.op(Opcode::Dp3, to, {s, wide.read()});
  } else {
    m_builder.op(Opcode::Dp3, to, {s, previous});
  }
  return to.read();
}

/// Returns the dot products of `count` stages from `first` on as a vector.
Source Stages::products(int first, int count) {
  if (count == 1)
    return dot(first);
  const Target to = m_builder.temporary();
  const char *const kMasks[] = {"x", "y", "z"};
  for (int i = 0; i < count; ++i)
    m_builder.op(Opcode::Mov, to.mask(kMasks[i]), {dot(first + i)});
  return to.read().swz(count == 2 ? "xyyy" : "xyzz");
}

/// Returns R = 2 (N . E) / (N . N) N - E (3.8.13.1.18 and 19).
Source Stages::reflected(int unit) {
  const Source normal = products(unit - 2, 3);
  Source eye;
  if (stage(unit).operation == Operation::DotProductConstEyeReflectCubeMap) {
    eye = m_builder.env(parameter(unit, Row::Eye));
  } else {
    const Target to = m_builder.temporary();
    m_builder.op(Opcode::Mov, to.mask("x"), {coordinates(unit - 2).swz("w")});
    m_builder.op(Opcode::Mov, to.mask("y"), {coordinates(unit - 1).swz("w")});
    m_builder.op(Opcode::Mov, to.mask("z"), {coordinates(unit).swz("w")});
    eye = to.read().swz("xyzz");
  }
  const Target work = m_builder.temporary(), to = m_builder.temporary();
  m_builder.op(Opcode::Dp3, work.mask("x"), {normal, normal});
  m_builder.op(Opcode::Rcp, work.mask("x"), {work.read().swz("x")});
  m_builder.op(Opcode::Dp3, work.mask("y"), {normal, eye});
  m_builder.op(Opcode::Mul, work.mask("x"), {work.read().swz("x"), work.read().swz("y")});
  m_builder.op(Opcode::Add, work.mask("x"), {work.read().swz("x"), work.read().swz("x")});
  m_builder.op(Opcode::Mad, to.mask("xyz"), {work.read().swz("x"), normal, -eye});
  return to.read().swz("xyzz");
}

/// Returns the colour scaled by the previous result's magnitude (3.8.13.1.9).
Source Stages::scaled(int unit) {
  std::optional<Source> &known = m_scaled[std::size_t(unit)];
  if (known)
    return *known;
  const Source row = m_builder.env(parameter(unit, Row::ScaleBias));
  const Source texel = result(unit);
  const Target scale = m_builder.temporary(), to = m_builder.temporary();
  m_builder.op(Opcode::Mad, scale.mask("x").sat(),
               {row.swz("x"), result(stage(unit).previous).swz("z"), row.swz("y")});
  m_builder.op(Opcode::Mul, to.mask("xyz"), {texel, scale.read().swz("x")});
  m_builder.op(Opcode::Mov, to.mask("w"), {texel});
  known = to.read();
  return *known;
}

/// Emits the culling of a stage: a component below zero passes LESS, any other passes GEQUAL
/// (3.8.13.1.7).
void Stages::cull(int unit) {
  const std::uint8_t less = stage(unit).cullLess & 15;
  const Source s = coordinates(unit);
  if (less == 0)
    return void(m_builder.kil(s));
  const Target passes = m_builder.temporary(); // a component below zero fails
  for (int i = 0; i < 4; ++i) {
    const Target to = passes.mask(ir::kLetters[i]);
    if ((less >> i & 1) == 0) {
      m_builder.op(Opcode::Mov, to, {s});
      continue;
    }
    m_builder.op(Opcode::Sge, to, {s, m_builder.constant(0.0f)});
    m_builder.op(Opcode::Mov, to, {-passes.read()});
  }
  m_builder.kil(passes.read());
}

/// Emits a depth replacement. A depth out of the depth range rejects the fragment (3.8.13.1.21 and
/// 37).
void Stages::replaceDepth(int unit) {
  const Target depth = m_builder.temporary("depth").mask("z");
  const Source z = depth.read().swz("z");
  if (info(unit).dots == 2) {
    m_builder.op(Opcode::Rcp, depth, {dot(unit).swz("x")});
    m_builder.op(Opcode::Mul, depth, {dot(unit - 1), z});
  } else {
    m_builder.op(Opcode::Mov, depth, {dot(unit)});
  }
  ir::StateRef ref;
  ref.item = ir::StateItem::DepthRange;
  const Source range = m_builder.state(ref); // near, far
  const Target limits = m_builder.temporary();
  m_builder.op(Opcode::Min, limits.mask("x"), {range.swz("x"), range.swz("y")});
  m_builder.op(Opcode::Max, limits.mask("y"), {range.swz("x"), range.swz("y")});
  m_builder.op(Opcode::Sub, limits.mask("x"), {z, limits.read()});
  m_builder.op(Opcode::Sub, limits.mask("y"), {limits.read(), z});
  m_builder.kil(limits.read().swz("xyyy"));
  m_builder.op(Opcode::Mov, m_builder.depth(), {z});
}

} // namespace arbiter::fp::texture_shader
