#include "fp_compiler/texture_shader/lower.h"

#include "fp_compiler/combiners/lower.h"
#include "fp_compiler/texture_shader/stages.h"

namespace arbiter::fp::texture_shader {

Key essential(const Key &key) {
  Key result;
  result.shaders = essential(key.shaders);
  result.combines = key.combines;
  result.fog = key.fog;
  if (key.combines) {
    result.combiners = combiners::essential(key.combiners);
    result.fx9 = key.fx9;
    return result;
  }
  result.environments = key.environments;
  result.colorSum = key.colorSum;
  for (Environment &environment : result.environments)
    if (environment.mode != EnvironmentMode::Combine)
      environment.color = environment.alpha = {};
  return result;
}

namespace {

/// Emits colour sum as amended (3.9) and sets the fog option. The secondary colour is added to the
/// colour clamped to [0,1].
void finishColor(ir::Builder &builder, const ir::Source &color, const Key &key) {
  builder.options().fog = key.fog;
  const ir::Target to = builder.color();
  if (!key.colorSum && key.fog == ir::FogMode::None) {
    builder.op(ir::Opcode::Mov, to, {color});
    return;
  }
  const ir::Target clamped = builder.temporary();
  builder.op(ir::Opcode::Mov, clamped.sat(), {color});
  if (key.colorSum) {
    const ir::Target secondary = builder.temporary();
    builder.op(ir::Opcode::Mov, secondary.mask("xyz").sat(),
               {builder.attribute(ir::AttributeKind::ColorSecondary)});
    builder.op(ir::Opcode::Add, clamped.mask("xyz").sat(), {clamped.read(), secondary.read()});
  }
  builder.op(ir::Opcode::Mov, to, {clamped.read()});
}

/// Returns the texture register of a unit for register combiners. For formats without a colour,
/// table RC.2 has only the alpha. Table 3.E has a white colour, and environments use the intensity.
std::optional<ir::Source> registerOf(Stages &stages, int unit) {
  const std::optional<ir::Source> color = stages.color(unit);
  const Base base = stages.environmentBase(unit);
  const bool alphaAlone = base == Base::Alpha || base == Base::DsdtMagIntensity;
  return color && alphaAlone ? color->swz("000w") : color;
}

} // namespace

ir::Program lower(const Key &key) {
  ir::Builder builder;
  Stages stages(builder, key.shaders);
  if (key.combines) {
    combiners::Surroundings around;
    around.fog = key.fog;
    around.fx9 = key.fx9;
    combiners::lower(builder, key.combiners, around,
                     [&](int unit) { return registerOf(stages, unit); });
  } else {
    std::array<Base, kUnits> bases{};
    for (int unit = 0; unit < key.shaders.units; ++unit)
      bases[std::size_t(unit)] = stages.environmentBase(unit);
    const ir::Source color = writeEnvironments(builder, key.environments, bases, [&](int unit) {
      const auto texel =
          unit < key.shaders.units ? stages.color(unit) : std::optional<ir::Source>{};
      return texel ? *texel : builder.constant(0.0f);
    });
    finishColor(builder, color, key);
  }
  stages.finish();
  return builder.take();
}

} // namespace arbiter::fp::texture_shader
