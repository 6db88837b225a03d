#include "state/programs/offered_targets.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "fp_compiler/ati/limits.h"
#include "host/host_table.h"
#include "state/era/era_state.h"
#include "state/identity/active_profile.h"
#include "state/imaging/imaging_state.h"
#include "state/programs/combiners/combiner_state.h"
#include "state/programs/nv/nv_state.h"
#include "state/programs/offered_aliases.h"
#include "state/programs/program_context.h"
#include "state/programs/state_texts.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Makes the target the layer's.
void offer(ProgramContext &context, Target target, fp::Limits limits) {
  ProgramTarget &row = context.row(target);
  row.offered = true;
  row.env.assign(limits.envParameters, Vec4{});
  row.limits = limits;
  context.group->setDefaultLocals(target, row.localsOfObject());
}

/// Offers NVIDIA's own languages and their API, if the profile has the first language.
void offerNvPrograms(ProgramContext &context) {
  const fp::Limits limits = context.row(Target::Vertex).limits;
  if (limits.nvVertexProgram == 0)
    return;
  context.row(Target::VertexState).limits = limits;
  context.nv = std::make_unique<NvState>();
}

/// Offers register combiners, if the profile's card has them.
void offerCombiners(ProgramContext &context) {
  const fp::hw::Combiners &card = activeProfile().combiners;
  if (card.general == 0)
    return;
  fp::Limits limits = context.row(Target::Fragment).limits;
  limits.envParameters = fp::combiners::kConstants;
  limits.localParameters = 0;
  limits.generalCombiners = card.general;
  limits.perStageConstants = card.perStageConstants;
  offer(context, Target::Combiners, limits);
  context.combiners = std::make_unique<CombinerState>(
      int(card.general), card.perStageConstants != 0,
      int(std::min(limits.textureUnits, std::uint32_t(fp::combiners::kTextures))));
}

/// Offers extensions that the profile has and the host lacks.
void offerEra(ProgramContext &context) {
  EraOffers offers = eraOffers(context.caps);
  if (!offers.any())
    return;
  context.era = std::make_unique<EraState>();
  context.era->offered = std::move(offers);
  if (context.era->offered.imaging)
    context.imaging = std::make_unique<ImagingState>();
  if (context.era->offered.vertexShader) {
    fp::Limits limits = context.row(Target::Vertex).limits;
    for (fp::ResourceCounts *const counts : {&limits.api, &limits.native})
      counts->instructions = std::min(counts->instructions, VertexShaderRecorder::kMaxInstructions);
    offer(context, Target::VertexShader, limits);
    context.vertexShaders = std::make_unique<VertexShaderState>();
  }
}

/// Offers texture shaders, if the profile's card and the host's formats support them.
void offerTextureShaders(ProgramContext &context) {
  fp::Limits limits = context.row(Target::Fragment).limits;
  const std::uint32_t extensions = activeProfile().textureShaders;
  if (extensions == 0 || !context.caps.drawsTextureShaders())
    return;
  limits.envParameters = fp::texture_shader::kParameters;
  limits.localParameters = 0;
  limits.textureShaders = extensions;
  limits.generalCombiners = activeProfile().combiners.general;
  limits.perStageConstants = activeProfile().combiners.perStageConstants;
  offer(context, Target::TextureShaders, limits);
  context.textureShaders =
      std::make_unique<TextureShaderState>(int(extensions), int(std::min(limits.textureUnits, 8u)));
  context.textureShaders->setParameters(context);
}

} // namespace

void offerTargets(ProgramContext &context) {
  for (const Target target : {Target::Fragment, Target::Vertex})
    offer(context, target, limitsUnder(activeProfile(), target, *context.host, context.caps));
  if (context.offered) {
    const fp::Limits limits = fp::ati::limitsOf(context.row(Target::Fragment).limits);
    offer(context, Target::AtiText, limits);
    offer(context, Target::AtiApi, limits);
    offerNvPrograms(context);
    offerAliases(context);
    offerCombiners(context);
    offerTextureShaders(context);
    if (context.combiners || context.textureShaders)
      context.stateTexts = makeStateTexts();
    offerEra(context);
  }
}

} // namespace arbiter::state
