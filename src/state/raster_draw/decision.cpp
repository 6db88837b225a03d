#include "state/raster_draw/decision.h"

#include <optional>

#include "state/core/context.h"
#include "state/core/control_hooks.h"
#include "state/host_draw/draw.h"
#include "state/host_draw/path_choice.h"
#include "state/programs/variants/point_sprites.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/functions/compile_thread.h"
#include "state/raster_draw/pipeline.h"

namespace arbiter::state::software {

namespace {

/// Draws that an observing client gives to the host must not count against the frame.
[[gnu::cold]] Outcome observed(Context &context) {
  context.software->observed = true;
  return Fallback::Observed;
}

/// Implements decideByPath(), always inline because every draw runs it.
[[gnu::always_inline]] inline Outcome judgePath(Context &context) {
  if (context.listMode != 0 || context.listIsExecuted) [[unlikely]]
    return Fallback::List;
  if (isObserved(context)) [[unlikely]]
    return observed(context);
  if (!context.effective.linkedProgram) {
    // The rasterizer also draws fixed function, without any program.
    if (context.effective.path == Path::HostAssembly && !applicationShades(context))
      return Fallback::NotCompiled; // too long
    if (context.effective.path != Path::NoProgram || applicationShades(context))
      return Fallback::NoFragmentProgram;
  }
  if (!context.software->residency.syncWithNeighbours()) [[unlikely]] {
    context.software->history.look.becomesHosts(); // a neighbour's draws go unnoticed
    return Fallback::Shared;
  }
  if (!context.software->history.backOff.engaged())
    return Fallback::BackedOff;
  return {};
}

/// Returns the slots of current values that vertices read. Unfilled polygons also read edge flags.
std::uint32_t currentSlotsOf(const Pipeline &pipeline, const Mirror &mirror) {
  const bool unfilled = mirror.raster.front != swrast::PolygonMode::Fill ||
                        mirror.raster.back != swrast::PolygonMode::Fill;
  return pipeline.currentSlots() | (unfilled ? 1u << kEdgeFlag : 0u);
}

/// True if a draw must match depths that the rasterizer wrote in this frame.
bool meetsDepths(const ContextState &state) {
  const abi::DepthStencilKey &depth = state.mirror.pixelOps.depthStencil;
  return state.depthsTested && (depth.depthTest != 0 || depth.stencilTest != 0);
}

} // namespace

bool executesNow(Context &context) {
  if (context.listMode != 0)
    context.list->notePixels();
  return !context.insideBeginEnd && context.listMode == 0;
}

bool usesRasterizer(Context &context) {
  return validatePrograms(context) && context.softwarePossible;
}

Outcome decideByPath(Context &context) { return judgePath(context); }

Outcome decideFragments(Context &context) {
  const Outcome path = judgePath(context);
  if (!path.ok() && path.reason() != Fallback::BackedOff)
    return path;
  Pipeline &pipeline = pipelineOf(context);
  const Outcome outcome = pipeline.chooseFragments(context);
  return !outcome.ok() || pipeline.readsRasterValues() ? outcome : path;
}

namespace {

[[gnu::always_inline]] inline Outcome choose(Context &context, const Pipeline::Kind &kind) {
  Pipeline &pipeline = pipelineOf(context);
  if (const Outcome outcome = pipeline.choose(context, kind); !outcome.ok())
    return outcome;
  Mirror &mirror = context.software->mirror;
  mirror.refreshCurrent(context.dirty, currentSlotsOf(pipeline, mirror));
  return {};
}

} // namespace

Outcome decide(Context &context, GLenum mode, std::uint32_t count, MaterialMask materials) {
  if (mode > GL_POLYGON)
    return Fallback::Vertices;
  notePrimitiveMode(context, mode);
  if (const Outcome outcome = judgePath(context); !outcome.ok())
    return outcome;
  return choose(context, {mode, count, materials});
}

Outcome decideAgain(Context &context, GLenum mode, MaterialMask materials) {
  return choose(context, {mode, 0, materials});
}

bool waitsForCode(Context &context, const Outcome &outcome) {
  const ContextState &state = *context.software;
  if (outcome.ok() || outcome.reason() != Fallback::Compiling ||
      !(meetsDepths(state) || state.history.look.isRasterizers() ||
        pipelineOf(context).readsRasterValues()))
    return false;
  awaitCompiler(std::nullopt);
  return true;
}

void noteDrawn(Context &context, std::uint32_t draws) {
  ContextState &state = *context.software;
  state.drawn += draws;
  state.depthsTested = state.depthsTested || pipelineOf(context).testsDepth();
  state.drawsPlain = state.drawsPlain && !context.effective.linkedProgram;
  context.counters.draws[std::size_t(Path::Rasterizer)] += draws;
}

void giveToHost(Context &context, Fallback reason) {
  ContextState &state = *context.software;
  state.fellBack(reason);
  state.hostDrew = true;
  // Some reasons say nothing about the frame: the rasterizer will take such draws later, or refuses
  // them only because the frame is mixed.
  const bool says = reason != Fallback::Compiling && reason != Fallback::Mixed &&
                    reason != Fallback::BackedOff && reason != Fallback::Observed;
  state.lookTurns += reason == Fallback::Look ? 1 : 0;
  if (says)
    state.hostDraws(fallbackName(reason));
  else
    state.residency.hostTakesTargets(fallbackName(reason));
  static_cast<void>(validate(context));
}

bool conclude(Context &context, const Outcome &outcome) {
  if (outcome.ok()) [[likely]]
    noteDrawn(context);
  else
    giveToHost(context, outcome.reason());
  return outcome.ok();
}

Pipeline &pipelineOf(Context &context) {
  ContextState &state = *context.software;
  if (!state.pipeline) [[unlikely]]
    state.pipeline = {new Pipeline, [](Pipeline *pipeline) { delete pipeline; }};
  return *state.pipeline;
}

} // namespace arbiter::state::software
