#include "state/programs/offered_targets.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "fp_compiler/ati/limits.h"
#include "host/host_table.h"
#include "state/core/active_profile.h"
#include "state/core/context.h"
#include "state/era/era_state.h"
#include "state/imaging/imaging_state.h"
#include "state/programs/combiners/combiner_state.h"
#include "state/programs/nv/nv_state.h"
#include "state/programs/state_texts.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/share/share_group.h"
#include "util/flags.h"

namespace arbiter::state {

namespace {

constexpr GLint kMostImageUnits = 32; ///< that the compiler numbers

/// The profile's limits of the target, no higher than the host can keep: what is promised must
/// draw.
fp::Limits limitsOf(Target target, const host::HostTable &host, const HostCaps &caps) {
  const fp::hw::Profile &profile = activeProfile();
  const bool vertex = target == Target::Vertex;
  const fp::Limits &ofProfile = vertex ? profile.vertex : profile.fragment;
  const bool fromHost = profile.fromHost && (vertex ? caps.vertexProgram : caps.fragmentProgram);
  fp::Limits limits = fromHost ? queryHostLimits(infoOf(target).name, host, caps) : ofProfile;
  limits.nvOptions = caps.drawsNvOptions() ? ofProfile.nvOptions : 0;
  limits.nvVertexProgram = caps.drawsNvOptions() ? ofProfile.nvVertexProgram : 0;
  // Vertex programs that sample may name the units of all stages.
  const GLint imageUnits = vertex && limits.nvOptions >= 2
                               ? std::min(caps.maxCombinedImageUnits, kMostImageUnits)
                               : caps.maxTextureImageUnits;
  if (fromHost) {
    limits.textureImageUnits = std::uint32_t(imageUnits);
    return limits;
  }
  const auto clamp = [](std::uint32_t &value, GLint host_) {
    value = std::min(value, std::uint32_t(std::max(host_, 0)));
  };
  clamp(limits.textureCoords, caps.maxTextureCoords);
  clamp(limits.textureImageUnits, imageUnits);
  clamp(limits.textureUnits, caps.maxTextureUnits);
  clamp(limits.programMatrices, caps.maxProgramMatrices);
  clamp(limits.programMatrixStackDepth, caps.maxProgramMatrixStackDepth);
  clamp(limits.vertexAttribs, caps.maxVertexAttribs);
  // These are limits of all drawing, so that the host answers for them unless the card is asked to
  // (cardValue() in gets.cpp). A program may use what the query promises, no more and no less.
  if (!settings().identityOfProfile)
    limits.drawBuffers = limits.clipPlanes = UINT32_MAX;
  clamp(limits.drawBuffers, caps.maxDrawBuffers);
  clamp(limits.clipPlanes, caps.maxClipPlanes);
  // GLSL has no names for them, so that no program could read them.
  limits.paletteMatrices = 0;
  limits.vertexUnits = 1;
  return limits;
}

/// The target is the layer's from now on.
void offer(Context &context, Target target, fp::Limits limits) {
  ProgramTarget &row = context.row(target);
  row.offered = true;
  row.env.assign(limits.envParameters, Vec4{});
  row.limits = limits;
  context.group->setDefaultLocals(target, row.localsOfObject());
}

/// NVIDIA's own languages and their API, where the profile has the first of them.
void offerNvPrograms(Context &context) {
  const fp::Limits limits = context.row(Target::Vertex).limits;
  if (limits.nvVertexProgram == 0)
    return;
  context.row(Target::VertexState).limits = limits;
  context.nv = std::make_unique<NvState>();
}

/// Register combiners, where the profile's card has them.
void offerCombiners(Context &context) {
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

/// Extensions that the host lacks and the profile has.
void offerEra(Context &context) {
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
      counts->instructions =
          std::min(counts->instructions, VertexShaderRecorder::kMostInstructions);
    offer(context, Target::VertexShader, limits);
    context.vertexShaders = std::make_unique<VertexShaderState>();
  }
}

/// Texture shaders, where the profile's card and the host's formats have them.
void offerTextureShaders(Context &context) {
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

void offerTargets(Context &context) {
  for (const Target target : {Target::Fragment, Target::Vertex})
    offer(context, target, limitsOf(target, *context.host, context.caps));
  if (context.offered) {
    const fp::Limits limits = fp::ati::limitsOf(context.row(Target::Fragment).limits);
    offer(context, Target::AtiText, limits);
    offer(context, Target::AtiApi, limits);
    offerNvPrograms(context);
    offerCombiners(context);
    offerTextureShaders(context);
    if (context.combiners || context.textureShaders)
      context.stateTexts = makeStateTexts();
    offerEra(context);
  }
}

} // namespace arbiter::state
