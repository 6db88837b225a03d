#include "state/raster_draw/immediate/primitive.h"

#include <exception>
#include <new>
#include <span>

#include "host/host_table.h"
#include "state/core/context.h"
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

namespace arbiter::state::software {

namespace {

/// Gives the host what there is of the primitive that was recorded, for the reason.
void replayFor(Context &context, Fallback reason) {
  withinMemory(context, "End", [&] { giveToHost(context, reason); });
  replayToHost(context);
}

/// What reaches pixels of materials that differ.
MaterialMask visible(Context &context) {
  const VertexState &state = context.software->mirror.vertex;
  if (!state.lighting || !pipelineOf(context).hasFixedVertices())
    return 0;
  return state.twoSided ? kAllMaterials : kFrontMaterial;
}

/// Before recorded vertices are drawn: those that have a material in common have it of the host,
/// and functions are chosen for the others. Not ok: the host draws. Requires: no primitive is open.
Outcome readyMaterials(Context &context) {
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

/// What is drawn with the functions that are chosen, after others have been chosen where materials
/// ask for them.
template <typename Draw> Outcome drawWithMaterials(Context &context, Draw draw) {
  return outcomeOf(context, [&] {
    const Outcome outcome = readyMaterials(context);
    return outcome.ok() ? draw() : outcome;
  });
}

/// Primitives [0, starts().size()) of the recorder, or with `last` the last one too. Not ok:
/// nothing has been drawn.
Outcome drawJoined(Context &context, const VertexSource &source, bool last) {
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

/// A primitive that was joined to others comes to have many vertices: those are drawn, and it goes
/// on alone. Where that cannot be all are the host's, with the vertex at `position`.
bool drawEarlier(void *owner, const float position[4]) {
  auto &context = *static_cast<Context *>(owner);
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

/// More vertices are recorded than a draw has arrays for: what is full of parts is drawn. Where
/// that cannot be the primitive is the host's from here on, with the vertex at `position`.
bool drawOpen(void *owner, const float position[4]) {
  auto &context = *static_cast<Context *>(owner);
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
    recorder.fail();         // and End says so
    startRecording(context); // an application that catches its own exception is before End still
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
  recorder.limit(kMostOpen, drawOpen, &context);
  if (!state.openParts && !recorder.failed())
    noteDrawn(context, state.held + 1);
  state.held = 0;
  state.openParts = true;
  startRecording(context);
  return !recorder.failed();
}

} // namespace

void limitOpen(Context &context) {
  ImmediateRecorder &recorder = context.software->recorder;
  if (opensInParts(context, pipelineOf(context)))
    recorder.limit(kMostAtOnce, drawOpen, &context);
  else
    recorder.unlimit();
}

bool openNext(Context &context) {
  ImmediateRecorder &recorder = context.software->recorder;
  try {
    recorder.next();
  } catch (const std::bad_alloc &) {
    return false;
  }
  recorder.limit(recorder.count() + kMostHeld, drawEarlier, &context);
  return true;
}

bool beginPrimitive(Context &context, GLenum mode) {
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

/// `primitives` that follow one another, of which some may have waited since their End.
void drawRecorded(Context &context, std::uint32_t primitives, bool haveWaited) {
  ContextState &state = *context.software;
  const VertexSource source = state.recorder.end();
  const std::uint32_t count = state.recorder.count();
  state.recordsMany = state.recordsMany || count >= kManyVertices;
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
    } catch (const std::exception &) { // the attributes have been set whatever was drawn
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

void endPrimitive(Context &context) {
  const std::uint32_t held = context.software->held;
  drawRecorded(context, held + 1, held != 0);
}

void endHeld(Context &context) { drawRecorded(context, context.software->held, true); }

} // namespace arbiter::state::software
