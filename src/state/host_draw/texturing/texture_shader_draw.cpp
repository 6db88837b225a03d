#include "state/host_draw/texturing/texture_shader_draw.h"

#include "fp_compiler/texture_shader/operations.h"
#include "state/host_draw/draw_context.h"
#include "state/host_draw/texturing/environment_now.h"
#include "state/host_draw/texturing/fixed_function_now.h"
#include "state/host_draw/texturing/sampler_override.h"
#include "state/host_draw/texturing/shader_textures.h"
#include "state/objects/linked_program.h"
#include "state/programs/combiners/combiner_state.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_edits.h"
#include "state/programs/state_text.h"
#include "state/programs/texture_changes.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

using fp::ir::TexTarget;
using fp::texture_shader::Base;
using fp::texture_shader::Operation;
using fp::texture_shader::Stage;
using fp::texture_shader::State;

Operation conventionalOperation(TexTarget target) {
  switch (target) {
  case TexTarget::Tex1D:
    return Operation::Texture1D;
  case TexTarget::Tex3D:
    return Operation::Texture3D;
  case TexTarget::Cube:
    return Operation::TextureCubeMap;
  case TexTarget::Rect:
    return Operation::TextureRectangle;
  default:
    return Operation::Texture2D;
  }
}

std::uint32_t allUnits(const DrawContext &context) {
  return (1u << unsigned(context.textureShaders->units())) - 1u;
}

void askTextures(DrawContext &context, State &state) {
  releaseSamplers(context); // query the application's samplers, not the layer's
  for (int unit = 0; unit < state.units; ++unit) {
    const auto &info = fp::texture_shader::infoOf(state.stages[std::size_t(unit)].operation);
    if (info.target)
      state.textures[std::size_t(unit)] = boundTexture(context, unit, *info.target);
  }
}

/// Adds the bump environments of conventional texturing to the state.
void addBumps(const TextureShaderSettings &settings,
              const fp::texture_shader::Environments &environments, State &state) {
  for (std::size_t unit = 0; unit < state.units; ++unit)
    if (environments[unit].mode == fp::texture_shader::EnvironmentMode::Combine &&
        environments[unit].color.function == fp::texture_shader::CombineFunction::BumpEnvmap)
      state.bumps[unit] = std::uint8_t(settings.bumpTargets[unit] + 1);
}

bool isEnabled(const DrawContext &context) {
  return context.row(Target::TextureShaders).enabled && !context.textureShaders->switchedOff;
}

/// Returns the stages and what they sample; conventional stages if TEXTURE_SHADER_NV is disabled.
/// \param instead stages that replace the application's
State stagesNow(DrawContext &context, const State *instead = nullptr) {
  const TextureShaderState &shaders = *context.textureShaders;
  State state;
  state.units = std::uint8_t(shaders.units());
  state.conventional = !isEnabled(context);
  if (!state.conventional) {
    state.stages = instead ? instead->stages : shaders.now().stages;
  } else {
    const fp::FixedFunction fixed = fixedFunctionNow(context, allUnits(context));
    for (std::size_t unit = 0; unit < state.units; ++unit)
      if ((fixed.disabledUnits >> unit & 1u) == 0)
        state.stages[unit].operation = conventionalOperation(fixed.targets[unit]);
  }
  askTextures(context, state);
  return state;
}

/// True if fixed function does not support the texture.
bool isSpecial(const fp::texture_shader::Texture &texture) {
  return texture.base >= Base::Hilo || texture.signs != fp::texture_shader::Signs::Unsigned;
}

/// Returns the text of the enabled stages, and of combiners after them.
const StateText &textOf(const DrawContext &context, bool combines) {
  fp::nvparse::Text own;
  State &shaders = own.shaders.emplace();
  shaders.units = std::uint8_t(context.textureShaders->units());
  shaders.stages = context.textureShaders->now().stages;
  if (combines)
    own.combiners = fp::combiners::essential(context.combiners->state());
  return context.stateTexts->of(context, Target::TextureShaders, own);
}

} // namespace

bool texturesSwitchedOff(DrawContext &context, bool combines) {
  bool &off = context.textureShaders->switchedOff;
  off = context.stateTexts && controlled() && ProgramEdits::instance().anyOff() &&
        ProgramEdits::instance().isOff(
            textFileName(Target::TextureShaders, textOf(context, combines).hash));
  return off;
}

std::shared_ptr<const CompiledProgram>
chooseTextureShaderProgram(DrawContext &context, const fp::GlslHost &host, bool combines) {
  TextureShaderState &shaders = keepTextures(context);
  fp::texture_shader::Key key;
  const StateText *const text =
      context.stateTexts && isEnabled(context) ? &textOf(context, combines) : nullptr;
  const fp::nvparse::Text *const instead = text && text->replaced ? &*text->replaced : nullptr;
  key.shaders = stagesNow(context, instead ? &*instead->shaders : nullptr);
  const fp::FixedFunction fixed = fixedFunctionNow(context, 0);
  key.fog = fixed.fog;
  key.combines = instead ? instead->combiners.has_value() : combines;
  if (key.combines) {
    key.combiners = instead ? *instead->combiners : context.combiners->state();
    key.fx9 = context.numerics == fp::Numerics::Fx9;
  } else {
    key.environments = environmentsNow(context);
    if (key.shaders.conventional)
      addBumps(shaders.now(), key.environments, key.shaders);
    key.colorSum = fixed.colorSum;
  }
  context.followsFixedFunction = true;
  shaders.effective = true;
  shaders.drawnUnder = key.shaders;
  return shaders.programUnder(context, fp::texture_shader::essential(key), host, text);
}

bool texturesNeedLayer(DrawContext &context) {
  if (!context.textureShaders || isEnabled(context))
    return false;
  const std::uint8_t none =
      context.textureShaders->now().environmentNone | context.textureShaders->now().bumps;
  if (none == 0 && !context.group->textureFormats.any()) [[likely]]
    return false;
  const State state = stagesNow(context);
  for (std::size_t unit = 0; unit < state.units; ++unit)
    if (isSpecial(state.textures[unit]) ||
        ((none >> unit & 1) != 0 && state.stages[unit].operation != Operation::None))
      return true;
  return false;
}

bool mayFollowTextures(const DrawContext &context) {
  return followsTextures(context) && texturesMayDiffer(context);
}

void followTextures(DrawContext &context) {
  if ((context.attention & attention::kProgram) != 0)
    return; // the choice will look anyway
  TextureShaderState &shaders = *context.textureShaders;
  if (!shaders.effective) {
    const LinkedProgram *const linked = context.effective.linkedProgram;
    const bool combines = linked && linked->fragment.compiled &&
                          linked->fragment.compiled->target == Target::Combiners;
    if ((combines || context.effective.path == Path::NoProgram) && texturesNeedLayer(context))
      invalidateProgram(context);
    return;
  }
  State now = shaders.drawnUnder;
  now.textures = {};
  askTextures(context, now);
  if (!(now == shaders.drawnUnder))
    invalidateProgram(context);
}

bool stageIsConsistent(DrawContext &context, int unit) {
  TextureShaderState &shaders = *context.textureShaders;
  State state;
  state.units = std::uint8_t(shaders.units());
  state.stages = shaders.now().stages;
  askTextures(context, state);
  return (fp::texture_shader::consistentStages(state) >> unit & 1u) != 0;
}

} // namespace arbiter::state
