#include "state/host_draw/texturing/combiner_draw.h"

#include <algorithm>

#include "fp_compiler/ir/reads.h"
#include "host/host_table.h"
#include "state/core/texture_names.h"
#include "state/core/unit_scope.h"
#include "state/host_draw/draw_context.h"
#include "state/host_draw/texturing/fixed_function_now.h"
#include "state/host_draw/texturing/sampler_override.h"
#include "state/programs/combiners/combiner_state.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_edits.h"
#include "state/programs/state_text.h"
#include "state/programs/texture_changes.h"

namespace arbiter::state {

namespace {

using fp::combiners::Surroundings;
using fp::combiners::Texel;
using fp::ir::TexTarget;

/// A target whose textures can be depths, without and with comparison.
struct DepthTarget {
  TexTarget plain, compares;
};
constexpr DepthTarget kDepthTargets[] = {{TexTarget::Tex1D, TexTarget::Shadow1D},
                                         {TexTarget::Tex2D, TexTarget::Shadow2D},
                                         {TexTarget::Rect, TexTarget::ShadowRect}};

const DepthTarget *depthTargetOf(TexTarget target) {
  const auto *const row =
      std::find_if(std::begin(kDepthTargets), std::end(kDepthTargets),
                   [&](const DepthTarget &r) { return r.plain == target || r.compares == target; });
  return row == std::end(kDepthTargets) ? nullptr : row;
}

/// True if the active unit compares depths of `target` with the r coordinate.
bool comparesNow(DrawContext &context, GLenum target) {
  GLint sampler = 0, mode = GL_NONE;
  if (context.caps.samplerObjects)
    context.host->GetIntegerv(GL_SAMPLER_BINDING, &sampler);
  if (sampler != 0)
    context.host->GetSamplerParameteriv(GLuint(sampler), GL_TEXTURE_COMPARE_MODE, &mode);
  else if (context.caps.shadow)
    context.host->GetTexParameteriv(target, GL_TEXTURE_COMPARE_MODE, &mode);
  return mode != GL_NONE;
}

/// Finds out, for the active unit, what its texture register gets, and by which target.
void askDepth(DrawContext &context, const DepthTarget &target, Texel &texel, TexTarget &sampled) {
  const host::HostTable &host = *context.host;
  const TextureNames names = textureNames(target.plain);
  // A query of a level that textures cannot have is an error. Every host has this many.
  constexpr GLint kSafeLevels = 12;
  GLint base = 0, depth = 0;
  host.GetTexParameteriv(names.target, GL_TEXTURE_BASE_LEVEL, &base);
  host.GetTexLevelParameteriv(names.level, base < kSafeLevels ? base : 0, GL_TEXTURE_DEPTH_SIZE,
                              &depth);
  texel = Texel::Color;
  sampled = target.plain;
  if (depth == 0)
    return;
  GLint mode = GL_LUMINANCE;
  host.GetTexParameteriv(names.target, GL_DEPTH_TEXTURE_MODE, &mode);
  texel = mode == GL_ALPHA ? Texel::DepthInAlpha : Texel::Depth;
  if (comparesNow(context, names.target))
    sampled = target.compares;
}

/// Finds out which units sample depths, of those whose targets are known.
void askDepths(DrawContext &context, Surroundings &around) {
  if (!mayCombineDepths(context))
    return;
  releaseSamplers(context); // query the application's samplers, not the layer's
  for (std::size_t unit = 0; unit < around.texels.size(); ++unit) {
    if (around.texels[unit] == Texel::None)
      continue;
    const DepthTarget *const target = depthTargetOf(around.targets[unit]);
    if (!target)
      continue;
    const UnitScope scope(*context.host, GLuint(unit));
    askDepth(context, *target, around.texels[unit], around.targets[unit]);
  }
}

/// Queries the state around the combiners that their program depends on.
Surroundings surroundingsNow(DrawContext &context, const fp::combiners::State &state) {
  const std::uint32_t read =
      fp::combiners::texturesRead(state) & ((1u << unsigned(context.combiners->units())) - 1u);
  const fp::FixedFunction fixed = fixedFunctionNow(context, read);
  Surroundings around;
  around.fog = fixed.fog;
  around.fx9 = context.numerics == fp::Numerics::Fx9;
  for (std::size_t unit = 0; unit < around.texels.size(); ++unit)
    if ((read >> unit & 1u) != 0 && (fixed.disabledUnits >> unit & 1u) == 0) {
      around.texels[unit] = Texel::Color;
      around.targets[unit] = fixed.targets[unit];
    }
  askDepths(context, around);
  return around;
}

const StateText &textOfCombiners(const DrawContext &context, const fp::combiners::State &state) {
  return context.stateTexts->of(context, Target::Combiners, {.combiners = state});
}

} // namespace

bool combinersSwitchedOff(DrawContext &context) {
  return context.stateTexts && controlled() && ProgramEdits::instance().anyOff() &&
         ProgramEdits::instance().isOff(textFileName(
             Target::Combiners,
             textOfCombiners(context, fp::combiners::essential(context.combiners->state())).hash));
}

std::shared_ptr<const CompiledProgram> chooseCombinerProgram(DrawContext &context,
                                                             const fp::GlslHost &host) {
  CombinerState &combiners = *context.combiners;
  fp::combiners::State state = fp::combiners::essential(combiners.state());
  const StateText *text = nullptr;
  if (context.stateTexts) {
    text = &textOfCombiners(context, state);
    if (text->replaced)
      state = fp::combiners::essential(*text->replaced->combiners);
  }
  combiners.drawnUnder = surroundingsNow(context, state);
  combiners.effective = true;
  context.followsFixedFunction = true;
  return combiners.programUnder(context, {state, combiners.drawnUnder}, host, text);
}

bool mayFollowCombinedDepths(const DrawContext &context) {
  return followsDepths(context) && texturesMayDiffer(context);
}

void followCombinedDepths(DrawContext &context) {
  if ((context.attention & attention::kProgram) != 0)
    return; // the program is about to be chosen, which asks for the depths
  Surroundings now = context.combiners->drawnUnder;
  askDepths(context, now);
  if (!(now == context.combiners->drawnUnder))
    invalidateProgram(context);
}

} // namespace arbiter::state
