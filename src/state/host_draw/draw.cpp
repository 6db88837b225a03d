// Prepares a draw on the host: brings the effective programs (path_choice.h) and their parameters
// into the host.
#include "state/host_draw/draw.h"

#include <algorithm>

#include "host/host_table.h"
#include "state/core/context_hooks.h"
#include "state/core/control_hooks.h"
#include "state/core/errors.h"
#include "state/core/garbage.h"
#include "state/host_draw/clip_planes.h"
#include "state/host_draw/draw_context.h"
#include "state/host_draw/draw_needs.h"
#include "state/host_draw/fixed_function.h"
#include "state/host_draw/kept_letters.h"
#include "state/host_draw/linking/fragment_assembly.h"
#include "state/host_draw/linking/host_assembly.h"
#include "state/host_draw/linking/linked_program_cache.h"
#include "state/host_draw/native_inputs.h"
#include "state/host_draw/path_choice.h"
#include "state/host_draw/stages/stage_pipeline.h"
#include "state/host_draw/texturing/combiner_draw.h"
#include "state/host_draw/texturing/sampler_override.h"
#include "state/host_draw/texturing/texture_shader_draw.h"
#include "state/host_draw/uniforms.h"
#include "state/objects/linked_program.h"
#include "state/programs/program_bind.h"
#include "state/programs/replacement.h"
#include "state/programs/texture_changes.h"
#include "state/programs/variants/alpha_depths.h"
#include "state/programs/variants/point_sprites.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/report/capture.h"
#include "state/share/share_group.h"
#include "util/flags.h"

namespace arbiter::state {

namespace {

void setPath(DrawContext &context, Path path) {
  context.effective.path = path;
  context.drawCounter = &context.counters.draws[std::size_t(path)];
}

void releaseHostProgram(DrawContext &context) {
  if (!context.hostProgramIsOurs)
    return;
  context.hostSide.stagePipeline->release(context);
  context.host->UseProgram(0);
  context.hostProgramIsOurs = false;
}

/// Makes the layer's GLSL current on the host.
void useHostPrograms(DrawContext &context, const LinkedProgram &linkedProgram) {
  if (linkedProgram.vertexProgram != 0) {
    context.hostSide.stagePipeline->use(context, linkedProgram.vertexProgram,
                                        linkedProgram.hostProgram);
    context.hostProgramIsOurs = true;
  } else {
    context.hostSide.stagePipeline->useAlone(context, linkedProgram.hostProgram);
  }
}

/// Chooses the effective programs and brings them into the host.
void install(DrawContext &context, HostPart part) {
  setPath(context, choosePath(context, part));
  context.attention |= attention::kParameters;
  if (context.effective.hostPartWaits)
    return;
  if (context.effective.path == Path::HostAssembly && !context.effective.linkedProgram) {
    if (context.hostSide.samplerOverride->active())
      context.hostSide.samplerOverride->release(context);
    return releaseHostProgram(context);
  }
  if (context.effective.path == Path::NoProgram && settings().alwaysFixedFunction &&
      !applicationShades(context))
    context.hooks->engageRasterizer(context);
  if (!context.effective.linkedProgram)
    return releaseHostState(context);
  if (context.effective.linkedProgram->fragment.compiled || settings().alwaysFixedFunction)
    context.hooks->engageRasterizer(context);
  context.hostSide.assembly->apply(context, *context.effective.linkedProgram);
  if (context.effective.linkedProgram->hostProgram == 0)
    return releaseHostProgram(context);
  useHostPrograms(context, *context.effective.linkedProgram);
}

/// Brings the effective programs into the host, if that was deferred.
void installHostPart(DrawContext &context) {
  const LinkedProgram *const before = context.effective.linkedProgram;
  context.attention |=
      attention::kProgram; // until it is done: if memory runs out, the next draw chooses again
  install(context, HostPart::Now);
  if (context.effective.linkedProgram != before)
    ++context.effective.selections;
}

void select(DrawContext &context, HostPart part) {
  captureLeave(context);
  const ControlHooks *const hooks = controlHooks();
  if (hooks) [[unlikely]]
    hooks->programsLeave(context);
  ++context.effective.selections;
  install(context, part);
  captureEnter(context);
  if (hooks) [[unlikely]]
    hooks->programsEnter(context);
}

/// True if another context has loaded a program in use here, or set one of its local parameters.
bool changedElsewhere(const DrawContext &context) {
  return std::any_of(context.targets.begin(), context.targets.end(), [](const ProgramTarget &row) {
    return row.enabled && row.bound->version.load(std::memory_order_acquire) != row.seenVersion;
  });
}

/// Updates what depends on the bound textures, once after each change.
void followTextureChanges(DrawContext &context) {
  if (mayFollowCombinedDepths(context)) [[unlikely]]
    followCombinedDepths(context);
  if (mayFollowTextures(context)) [[unlikely]]
    followTextures(context);
  context.texturesChanged = false;
}

/// Updates GL state that reaches vertex programs as parameters or attributes.
void refreshInputs(DrawContext &context) {
  if (context.aliases)
    refreshNativeInputs(context);
  if (context.vertexShaders)
    refreshVertexShader(context);
}

/// Returns the effective vertex program if it is the host's own, and if its local parameters are
/// those that the application sets. Returns null otherwise.
AssemblyProgram *verticesOfOwnLocals(const DrawContext &context) {
  AssemblyProgram *const vertices =
      context.effective.linkedProgram ? context.effective.linkedProgram->vertexAssembly : nullptr;
  return vertices && vertices->stage.compiled->target == Target::Vertex && !controlHooks()
             ? vertices
             : nullptr;
}

/// Updates the effective programs if they may have changed.
void refreshEffective(DrawContext &context, HostPart part) {
  if (context.group->hasGarbage())
    collectGarbage(context);
  if ((context.attention & attention::kShared) != 0 && changedElsewhere(context))
    context.attention |= attention::kProgram;
  // A change of the program takes the need to watch back, and some applications make one before
  // each draw.
  if ((context.attention & (attention::kProgram | attention::kWatch)) != 0) {
    if (const ControlHooks *const hooks = controlHooks())
      hooks->beforeDraw(context);
    refreshReplacements(context);
  }
  if ((context.attention & attention::kProgram) != 0)
    select(context, part);
  else if (context.effective.hostPartWaits && part == HostPart::Now)
    installHostPart(context);
}

void sendKeptLetters(DrawContext &context) {
  if ((context.attention & attention::kLetters) != 0) [[unlikely]]
    drawKeptLetters(context);
}

void followDepths(DrawContext &context) {
  if (mayFollowAlphaDepths(context)) [[unlikely]]
    followAlphaDepths(context);
}

/// Chooses anew if the effective programs are assembly that the host should not have any more.
void leaveCrowdedAssembly(DrawContext &context) {
  const LinkedProgram *const linkedProgram = context.effective.linkedProgram;
  if (!linkedProgram || !linkedProgram->fragmentAssembly || !assemblyIsOver(context))
    return;
  invalidateProgram(context);
  refreshEffective(context, HostPart::Now);
}

/// Sends env and local parameters to the host, for the stages that `needs` names.
void sendParameters(DrawContext &context, std::uint32_t needs) {
  if (LinkedProgram *const linkedProgram = context.effective.linkedProgram)
    uploadParameters(context, *linkedProgram, needs);
  else if (context.effective.path == Path::HostAssembly && (needs & attention::kParameters) != 0)
    context.hostSide.assembly->uploadParameters(context, needs);
}

/// Binds sampler objects that do not compare depths where `needed`, and else the application's.
void applySamplers(DrawContext &context, bool needed) {
  LinkedProgram *const linkedProgram = context.effective.linkedProgram;
  SamplerOverride &samplers = *context.hostSide.samplerOverride;
  if (linkedProgram && needed)
    samplers.apply(context, *linkedProgram);
  else if (linkedProgram && samplers.active())
    samplers.release(context);
}

} // namespace

bool validatePrograms(DrawContext &context) {
  refreshInputs(context);
  followTextureChanges(context);
  constexpr std::uint32_t kMayChange = attention::kProgram | attention::kWatch | attention::kShared;
  const bool known = (context.attention & kMayChange) == 0 && !context.group->hasGarbage() &&
                     context.group->contexts.load(std::memory_order_relaxed) == 1;
  // A capture records what was sent to the host, so the host must be brought up to date.
  if (capturing()) [[unlikely]]
    return validate(context);
  if (known) [[likely]]
    return !isDropped(context.effective.path);
  // A client of the control interface is told how the programs draw, so the choice cannot wait.
  refreshEffective(context, controlHooks() ? HostPart::Now : HostPart::WhenItDraws);
  context.attention =
      lastingNeeds(context) | (context.attention & (attention::kRemains | attention::kParameters));
  return !isDropped(context.effective.path);
}

bool sendParametersAlone(DrawContext &context) {
  if ((context.attention & ~attention::kParameters) != 0 || context.listMode != 0 ||
      context.insideBeginEnd || context.passThrough ||
      context.group->contexts.load(std::memory_order_relaxed) != 1)
    return false;
  // Vertex shaders look for their invariants in their symbols, so they need the full path.
  if (context.vertexShaders && context.vertexShaders->effective)
    return false;
  // validatePrograms() does not update these, and leaves parameters to be sent.
  if (context.hostSide.samplerOverride->active() || !spritesAreTheHosts(context))
    return false;
  const LinkedProgram *const linkedProgram = context.effective.linkedProgram;
  if (linkedProgram && linkedProgram->fragmentAssembly &&
      linkedProgram->fragmentAssembly->changesOften)
    return false; // validate() will choose anew
  sendParameters(context, context.attention);
  context.attention = 0;
  context.hostSide.assembly->sendDirectly(verticesOfOwnLocals(context));
  return true;
}

bool validate(DrawContext &context) {
  sendKeptLetters(context);
  refreshInputs(context);
  followDepths(context);
  followTextureChanges(context);
  followSprites(context);
  refreshEffective(context, HostPart::Now);
  leaveCrowdedAssembly(context);
  applySprites(context);
  const std::uint32_t lasting = lastingNeeds(context);
  sendParameters(context, context.attention);
  applySamplers(context, (lasting & attention::kCompare) != 0);
  context.attention = lasting | (context.attention & attention::kRemains);
  context.hostSide.assembly->sendDirectly(verticesOfOwnLocals(context));
  return !isDropped(context.effective.path);
}

void releaseHostState(DrawContext &context) {
  if (context.hostSide.samplerOverride->active())
    context.hostSide.samplerOverride->release(context);
  context.hostSide.assembly->release(context);
  releaseHostProgram(context);
}

void refuseDraws(DrawContext &context) {
  if (context.hostSide.assembly->refuse(context))
    return;
  // Without assembly programs, the host cannot be made to refuse draws, only to draw nothing.
  static const std::shared_ptr<const CompiledProgram> s_mute = [] {
    auto program = std::make_shared<CompiledProgram>();
    program->glsl.text = "#version 120\nvoid main() { discard; }\n";
    return program;
  }();
  const LinkedProgram &mute = *context.hostSide.linkedPrograms->get(context, {nullptr, s_mute});
  if (mute.hostProgram == 0)
    return;
  useHostPrograms(context, mute);
}

void validateForList(DrawContext &context) {
  if (!validate(context))
    refuseDraws(context);
}

void afterHostList(DrawContext &context) {
  noteFixedFunctionChange(context);
  noteTextureChange(context);
  noteClipPlanesAfterList(context);
  if (!context.group->hostListsChangeProgram.load(std::memory_order_relaxed))
    return;
  GLint current = 0;
  context.host->GetIntegerv(GL_CURRENT_PROGRAM, &current);
  context.hostSide.stagePipeline->forgetCurrent();
  // An earlier program of the layer's may be current while the host part is deferred.
  if (context.hostProgramIsOurs && (context.group->ownsHostProgram(GLuint(current)) ||
                                    (current == 0 && context.hostSide.stagePipeline->isBound())))
    return;
  context.hostSide.stagePipeline->release(context);
  context.hostProgramIsOurs = false;
  context.application.program = GLuint(current);
  context.application.programKnown = true;
  invalidateProgram(context);
}

} // namespace arbiter::state
