#include "state/raster_draw/decision.h"

#include <optional>

#include "state/core/control_hooks.h"
#include "state/host_draw/draw.h"
#include "state/host_draw/path_choice.h"
#include "state/programs/variants/point_sprites.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/functions/compile_thread.h"
#include "state/raster_draw/pipeline.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

/// Draws that an observing client gives to the host must not count against the frame.
[[gnu::cold]] Outcome observed(RasterContext &context) {
  context.software->frame.observed = true;
  return Fallback::Observed;
}

/// Implements decideByPath(), always inline because every draw runs it.
[[gnu::always_inline]] inline Outcome judgePath(RasterContext &context) {
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
  return state.frame.depthsTested && (depth.depthTest != 0 || depth.stencilTest != 0);
}

} // namespace

bool usesRasterizer(RasterContext &context) {
  return validatePrograms(context) && context.softwarePossible;
}

bool isCandidate(RasterContext &context) {
  return executesPixels(context) && usesRasterizer(context);
}

Outcome decideByPath(RasterContext &context) { return judgePath(context); }

Outcome decideFragments(RasterContext &context) {
  const Outcome path = judgePath(context);
  if (!path.ok() && path.reason() != Fallback::BackedOff)
    return path;
  Pipeline &pipeline = pipelineOf(context);
  const Outcome outcome = pipeline.chooseFragments(context);
  return !outcome.ok() || pipeline.readsRasterValues() ? outcome : path;
}

namespace {

[[gnu::always_inline]] inline Outcome choose(RasterContext &context, const Pipeline::Kind &kind) {
  Pipeline &pipeline = pipelineOf(context);
  if (const Outcome outcome = pipeline.choose(context, kind); !outcome.ok())
    return outcome;
  Mirror &mirror = context.software->mirror;
  mirror.refreshCurrent(context.dirty, currentSlotsOf(pipeline, mirror));
  return {};
}

} // namespace

Outcome decide(RasterContext &context, GLenum mode, std::uint32_t count, MaterialMask materials) {
  if (mode > GL_POLYGON)
    return Fallback::Vertices;
  notePrimitiveMode(context, mode);
  if (const Outcome outcome = judgePath(context); !outcome.ok())
    return outcome;
  return choose(context, {mode, count, materials});
}

Outcome decideAgain(RasterContext &context, GLenum mode, MaterialMask materials) {
  return choose(context, {mode, 0, materials});
}

bool waitsForCode(RasterContext &context, const Outcome &outcome) {
  const ContextState &state = *context.software;
  if (outcome.ok() || outcome.reason() != Fallback::Compiling ||
      !(meetsDepths(state) || state.history.look.isRasterizers() ||
        pipelineOf(context).readsRasterValues()))
    return false;
  awaitCompiler(std::nullopt);
  return true;
}

void noteDrawn(RasterContext &context, std::uint32_t draws) {
  ContextState &state = *context.software;
  state.drawn += draws;
  state.frame.depthsTested = state.frame.depthsTested || pipelineOf(context).testsDepth();
  state.habits.drawsPlain = state.habits.drawsPlain && !context.effective.linkedProgram;
  context.counters.draws[std::size_t(Path::Rasterizer)] += draws;
}

void giveToHost(RasterContext &context, Fallback reason) {
  ContextState &state = *context.software;
  state.fellBack(reason);
  state.frame.hostDrew = true;
  // Some reasons say nothing about the frame: the rasterizer will take such draws later, or refuses
  // them only because the frame is mixed.
  const bool says = reason != Fallback::Compiling && reason != Fallback::Mixed &&
                    reason != Fallback::BackedOff && reason != Fallback::Observed;
  state.frame.lookTurns += reason == Fallback::Look ? 1 : 0;
  if (says)
    state.hostDraws(fallbackName(reason));
  else
    state.residency.hostTakesTargets(fallbackName(reason));
  static_cast<void>(validate(context));
}

bool conclude(RasterContext &context, const Outcome &outcome) {
  if (outcome.ok()) [[likely]]
    noteDrawn(context);
  else
    giveToHost(context, outcome.reason());
  return outcome.ok();
}

Pipeline &pipelineOf(RasterContext &context) {
  ContextState &state = *context.software;
  if (!state.pipeline) [[unlikely]]
    state.pipeline = {new Pipeline, [](Pipeline *pipeline) { delete pipeline; }};
  return *state.pipeline;
}

} // namespace arbiter::state
