#include "state/raster_draw/immediate/primitive.h"

#include <exception>
#include <new>
#include <span>

#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/core/memory.h"
#include "state/primitives/joined.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/decision.h"
#include "state/raster_draw/draw.h"
#include "state/raster_draw/immediate/held.h"
#include "state/raster_draw/immediate/primitive_materials.h"
#include "state/raster_draw/immediate/replay.h"
#include "state/raster_draw/large_draw.h"
#include "state/raster_draw/pipeline.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

/// Gives the recorded vertices to the host, and counts the reason.
void replayFor(RasterContext &context, Fallback reason) {
  withinMemory(context, "End", [&] { giveToHost(context, reason); });
  replayToHost(context);
}

/// Returns the material parts that affect pixels if they differ.
MaterialMask visible(RasterContext &context) {
  const VertexState &state = context.software->mirror.vertex;
  if (!state.lighting || !pipelineOf(context).hasFixedVertices())
    return 0;
  return state.twoSided ? kAllMaterials : kFrontMaterial;
}

/// Prepares the materials of recorded vertices. Parts that all vertices share are set on the host,
/// and functions are chosen for the others. Not ok if the host must draw. Requires that no
/// primitive is open.
Outcome readyMaterials(RasterContext &context) {
  ContextState &state = *context.software;
  MaterialParts &materials = state.materials;
  const MaterialMask touched = materialsIn(state.recorder.touched());
  if ((touched | materials.chosen) == 0 && !materials.isUndecided) [[likely]]
    return {};
  const auto common = MaterialMask(touched & ~(materials.differing | materials.given));
  const auto differing = MaterialMask(materials.differing & visible(context));
  if (common == 0 && differing == materials.chosen && !materials.isUndecided)
    return {};
  setCurrentValues(context, state.recorder.values(), slotsOfMaterials(common));
  materials.given |= common;
  materials.chosen = differing;
  const Outcome outcome = decideAgain(context, state.recorder.mode(), differing);
  materials.isUndecided = !outcome.ok();
  return outcome;
}

/// Draws with the chosen functions, after choosing others if materials require it.
template <typename Draw> Outcome drawWithMaterials(RasterContext &context, Draw draw) {
  return outcomeOf(context, [&] {
    const Outcome outcome = readyMaterials(context);
    return outcome.ok() ? draw() : outcome;
  });
}

/// Draws the recorder's primitives [0, starts().size()), and with `last` the last one too. If the
/// outcome is not ok, nothing has been drawn.
Outcome drawJoined(RasterContext &context, const VertexSource &source, bool last) {
  ContextState &state = *context.software;
  const ImmediateRecorder &recorder = state.recorder;
  const std::span<const std::uint32_t> starts = recorder.starts();
  const std::uint32_t end = last ? recorder.count() : starts.back();
  const auto joining = joiningOf(state.mirror.raster, recorder.mode());
  if (!joining)
    return Fallback::State;
  makeIndices(state.joinedIndices, recorder.mode(), last ? starts : starts.first(starts.size() - 1),
              end);
  if (state.joinedIndices.empty())
    return {};
  return pipelineOf(context).shadeJoined(
      context, source,
      {state.joinedIndices.data(), std::uint32_t(state.joinedIndices.size()), 0, end - 1},
      *joining);
}

/// Draws the earlier primitives, because the last one gets many vertices, and lets it continue
/// alone. If that fails, the host gets all of them, and the vertex at `position`. Returns false
/// then.
bool drawEarlier(void *owner, const float position[4]) {
  auto &context = *static_cast<RasterContext *>(owner);
  ContextState &state = *context.software;
  ImmediateRecorder &recorder = state.recorder;
  stopRecording(context);
  context.insideBeginEnd = false;
  Outcome outcome = Fallback::Shared;
  withinMemory(context, "glVertex", [&] {
    if (state.residency.syncWithNeighbours())
      outcome =
          drawWithMaterials(context, [&] { return drawJoined(context, recorder.end(), false); });
  });
  if (!outcome.ok()) {
    replayFor(context, outcome.reason());
    context.insideBeginEnd = true;
    setAttribute(*context.host, kPosition, position);
    return false;
  }
  recorder.forgetEarlier();
  noteDrawn(context, state.held);
  state.held = 0;
  limitOpen(context);
  startRecording(context);
  return true;
}

/// Draws the full parts of a primitive that has more vertices than a draw may have. If that fails,
/// the host gets the primitive from here on, and the vertex at `position`. Returns false then.
bool drawOpen(void *owner, const float position[4]) {
  auto &context = *static_cast<RasterContext *>(owner);
  ContextState &state = *context.software;
  ImmediateRecorder &recorder = state.recorder;
  stopRecording(context);
  context.insideBeginEnd = false;
  Pipeline &pipeline = pipelineOf(context);
  const OpenPart part = openPart(pipeline, recorder.count());
  const VertexSource source = recorder.end();
  Outcome outcome;
  try {
    outcome = drawWithMaterials(
        context, [&] { return drawInParts(context, pipeline, source, {.count = part.drawn}); });
  } catch (const std::exception &error) {
    recorder.fail(); // End reports it
    // an application that catches its own exception is still between Begin and End
    startRecording(context);
    passOn(error);
    stopRecording(context);
    context.insideBeginEnd = false;
  }
  if (!outcome.ok()) {
    replayFor(context, outcome.reason());
    context.insideBeginEnd = true;
    setAttribute(*context.host, kPosition, position);
    return false;
  }
  recorder.forget(part.kept, part.done);
  recorder.limit(kMaxOpen, drawOpen, &context);
  if (!state.openParts && !recorder.failed())
    noteDrawn(context, state.held + 1);
  state.held = 0;
  state.openParts = true;
  startRecording(context);
  return !recorder.failed();
}

} // namespace

void limitOpen(RasterContext &context) {
  ImmediateRecorder &recorder = context.software->recorder;
  if (opensInParts(context, pipelineOf(context)))
    recorder.limit(kMaxAtOnce, drawOpen, &context);
  else
    recorder.unlimit();
}

bool openNext(RasterContext &context) {
  ImmediateRecorder &recorder = context.software->recorder;
  try {
    recorder.next();
  } catch (const std::bad_alloc &) {
    return false;
  }
  recorder.limit(recorder.count() + kMaxHeld, drawEarlier, &context);
  return true;
}

bool beginPrimitive(RasterContext &context, GLenum mode) {
  ContextState &state = *context.software;
  const Outcome outcome =
      outcomeOf(context, [&] { return decide(context, mode, 0, state.materials.chosen); });
  if (!outcome.ok()) {
    state.materials.chosen = 0;
    giveToHost(context, outcome.reason());
    return false;
  }
  state.materials.begin(!pipelineOf(context).programReadsMaterials());
  state.recorder.begin(mode, state.mirror.current);
  state.openParts = false;
  state.held = 0;
  limitOpen(context);
  return true;
}

namespace {

/// Draws `primitives` consecutive primitives. \param haveWaited true if they were held
void drawRecorded(RasterContext &context, std::uint32_t primitives, bool haveWaited) {
  ContextState &state = *context.software;
  const VertexSource source = state.recorder.end();
  const std::uint32_t count = state.recorder.count();
  state.habits.recordsMany = state.habits.recordsMany || count >= kManyVertices;
  state.held = 0;
  Outcome outcome;
  if (state.recorder.failed())
    outcome = Fallback::Memory;
  else if (haveWaited && !state.residency.syncWithNeighbours())
    outcome = Fallback::Shared;
  else if (count != 0)
    try {
      outcome = drawWithMaterials(context, [&] {
        if (state.openParts)
          return drawInParts(context, pipelineOf(context), source, {.count = count});
        return state.recorder.starts().empty() ? drawSource(context, source, count)
                                               : drawJoined(context, source, true);
      });
    } catch (const std::exception &) { // attributes keep their values whatever was drawn
      setCurrentValues(context, state.recorder.values(), slotsToSet(context));
      throw;
    }
  if (!outcome.ok()) {
    replayFor(context, outcome.reason());
    context.host->End();
    if (state.recorder.failed())
      raise(context, GL_OUT_OF_MEMORY, "End: no memory for the primitive's vertices");
    return;
  }
  setCurrentValues(context, state.recorder.values(), slotsToSet(context));
  if (!state.openParts)
    noteDrawn(context, primitives);
}

} // namespace

void endPrimitive(RasterContext &context) {
  const std::uint32_t held = context.software->held;
  drawRecorded(context, held + 1, held != 0);
}

void endHeld(RasterContext &context) { drawRecorded(context, context.software->held, true); }

} // namespace arbiter::state
