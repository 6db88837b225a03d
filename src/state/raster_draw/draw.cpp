#include "state/raster_draw/draw.h"

#include <exception>

#include "host/host_table.h"
#include "state/core/context.h"
#include "state/core/errors.h"
#include "state/core/memory.h"
#include "state/host_draw/draw.h"
#include "state/raster_draw/compile_thread.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/large_draw.h"
#include "state/raster_draw/pipeline.h"
#include "state/raster_draw/replay.h"
#include "state/raster_draw/vertices/array_source.h"

namespace arbiter::state::software {

namespace {

/// The host draws: it is brought up to date with pixels and with what draws of ours left out, and
/// what it draws to is its own from here on.
void giveToHost(Context &context, Fallback reason) {
  context.software->fellBack(reason);
  context.software->hostDrew = true;
  // What will be ours later, or is not ours for this alone, says nothing about the frame.
  const bool says =
      reason != Fallback::Compiling && reason != Fallback::Mixed && reason != Fallback::BackedOff;
  if (says)
    context.software->hostDraws(fallbackName(reason));
  else
    context.software->residency.hostTakesTargets(fallbackName(reason));
  static_cast<void>(validate(context));
}

/// Contents of the arrays of one draw.
struct OpenArrays {
  OpenArrays(Context &inContext, ArraySource &ofSource) : context(inContext), source(ofSource) {}
  ~OpenArrays() { source.close(context); }
  OpenArrays(const OpenArrays &) = delete;
  OpenArrays &operator=(const OpenArrays &) = delete;
  Context &context;
  ArraySource &source;
};

Pipeline &pipelineOf(Context &context) {
  ContextState &state = *context.software;
  if (!state.draws)
    state.draws = std::make_unique<Pipeline>();
  return static_cast<Pipeline &>(*state.draws);
}

/// What keeps any draw of now with the host, as far as that is known without looking at state.
Outcome judge(Context &context) {
  if (context.listMode != 0)
    return Fallback::List;
  // Fixed function alone is ours too, once a program of ours has been drawn.
  if (context.path == Path::HostAssembly && !applicationShades(context))
    return Fallback::NotCompiled; // too long
  if (context.path != Path::HostGlsl && context.path != Path::NoProgram)
    return Fallback::NoFragmentProgram;
  if (context.path == Path::NoProgram && applicationShades(context))
    return Fallback::NoFragmentProgram;
  if (!context.software->residency.settle())
    return Fallback::Shared;
  if (!context.software->backOff.engaged())
    return Fallback::BackedOff;
  return {};
}

Outcome prepare(Context &context, GLenum mode, std::uint32_t count) {
  if (mode > GL_POLYGON)
    return Fallback::Vertices;
  if (const Outcome outcome = judge(context); !outcome.ok())
    return outcome;
  return pipelineOf(context).choose(context, {mode, count});
}

/// Whether a draw must meet depths that the rasterizer wrote in this frame.
bool meetsOurDepths(const ContextState &state) {
  const abi::DepthStencilKey &depth = state.mirror.pixelOps.depthStencil;
  return state.depthsTested && (depth.depthTest != 0 || depth.stencilTest != 0);
}

/// What a draw comes to. Where the host would draw it only because its machine code is still in the
/// making, and its depths would then not meet those of earlier passes, the code is waited for; what
/// takes longer than a part of a second is not in the making (fp_compiler's budget).
template <typename Attempt> Outcome settled(Context &context, Attempt attempt) {
  Outcome outcome = attempt();
  // A program is prepared, then its vertex and its fragment function are made: one after the other.
  for (int step = 0; step < 4 && !outcome.ok() && outcome.reason() == Fallback::Compiling &&
                     meetsOurDepths(*context.software);
       ++step) {
    awaitCompiler(std::nullopt);
    outcome = attempt();
  }
  return outcome;
}

/// What a draw wants of the current values: unfilled polygons have edge flags too.
std::uint32_t slotsOf(const Pipeline &pipeline, const Mirror &mirror) {
  const bool unfilled = mirror.raster.front != swrast::PolygonMode::Fill ||
                        mirror.raster.back != swrast::PolygonMode::Fill;
  return pipeline.currentSlots() | (unfilled ? 1u << kEdgeFlag : 0u);
}

/// All of a source's vertices, by a pipeline that has chosen.
Outcome shadeAll(Context &context, const VertexSource &source, std::uint32_t count) {
  Pipeline &pipeline = pipelineOf(context);
  const VertexSequence sequence = {.count = count};
  if (isLarge(sequence)) [[unlikely]]
    return drawInParts(context, pipeline, source, sequence);
  return pipeline.shade(context, source, {}, 0, count);
}

Outcome drawFromArrays(Context &context, const DrawCommand &command) {
  Pipeline &pipeline = pipelineOf(context);
  Mirror &mirror = context.software->mirror;
  mirror.refreshArrays();
  mirror.refreshCurrent(context.dirty, slotsOf(pipeline, mirror));
  const std::uint32_t slots = pipeline.slots() | 1u << kEdgeFlag;
  ArraySource &arrays = pipeline.arrays();
  const OpenArrays open(context, arrays);
  if (!arrays.open(context, mirror, slots, command))
    return Fallback::Vertices;
  const VertexSequence sequence = {std::uint32_t(command.first), std::uint32_t(command.count),
                                   command.indexType, arrays.indices(), command.baseVertex};
  if (isLarge(sequence)) [[unlikely]]
    return drawInParts(context, pipeline, arrays.source(), sequence);
  IndexRange range;
  if (command.indexType != 0 &&
      !pipeline.fetcher().decodeIndices(command.indexType, arrays.indices(),
                                        std::uint32_t(command.count), command.baseVertex, range))
    return Fallback::Vertices;
  if (isLarge(range)) [[unlikely]]
    return drawInParts(context, pipeline, arrays.source(), sequence);
  const auto first = std::uint32_t(command.first), count = std::uint32_t(command.count);
  if (!VertexFetcher::isSparse(range)) [[likely]]
    return pipeline.shade(context, arrays.source(), range, first, count);
  VertexSource compacted = arrays.source();
  if (!pipeline.fetcher().compact(compacted, slots, range))
    return Fallback::Vertices;
  return pipeline.shade(context, compacted, range, first, count);
}

void noteDrawn(Context &context) {
  ContextState &state = *context.software;
  ++state.drawn;
  state.depthsTested = state.depthsTested || pipelineOf(context).testsDepth();
  ++context.draws[std::size_t(Path::Rasterizer)];
}

/// Counts whose draw it was; the host is brought up to date for its own.
bool conclude(Context &context, const Outcome &outcome) {
  if (!outcome.ok()) {
    giveToHost(context, outcome.reason());
    return false;
  }
  noteDrawn(context);
  return true;
}

} // namespace

bool drawArrays(Context &context, const DrawCommand &command) {
  // What the host owes an error for, or draws nothing for, is the host's.
  if (!context.software || context.insideBeginEnd || context.listMode == GL_COMPILE ||
      command.count <= 0 || command.first < 0)
    return false;
  return conclude(context, settled(context, [&] {
                    const Outcome outcome =
                        prepare(context, command.mode, std::uint32_t(command.count));
                    return outcome.ok() ? drawFromArrays(context, command) : outcome;
                  }));
}

bool drawVertices(Context &context, GLenum mode, const VertexSource *source, std::uint32_t count) {
  return conclude(context, settled(context, [&] {
                    const Outcome outcome =
                        source ? prepare(context, mode, count) : Outcome(Fallback::Vertices);
                    if (!outcome.ok())
                      return outcome;
                    Mirror &mirror = context.software->mirror;
                    mirror.refreshCurrent(context.dirty, slotsOf(pipelineOf(context), mirror));
                    return shadeAll(context, *source, count);
                  }));
}

bool drawBits(Context &context, const PlacedBits &bits) {
  return conclude(context, settled(context, [&] {
                    const Outcome outcome = judge(context);
                    return outcome.ok() ? pipelineOf(context).shadeBits(context, bits) : outcome;
                  }));
}

namespace {

/// Gives the host what there is of the primitive that was recorded, for the reason.
void replayFor(Context &context, Fallback reason) {
  withinMemory(context, "End", [&] { giveToHost(context, reason); });
  replayToHost(context);
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
    outcome = settled(
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
    tellAttribute(*context.host, kPosition, position);
    return false;
  }
  recorder.forget(part.kept, part.done);
  recorder.limit(kMostOpen, drawOpen, &context);
  if (!state.openParts && !recorder.failed())
    noteDrawn(context);
  state.openParts = true;
  startRecording(context);
  return !recorder.failed();
}

} // namespace

bool begin(Context &context, GLenum mode) {
  if (!context.software || context.listMode == GL_COMPILE)
    return false;
  const Outcome outcome = settled(context, [&] { return prepare(context, mode, 0); });
  if (!outcome.ok()) {
    giveToHost(context, outcome.reason());
    return false;
  }
  Mirror &mirror = context.software->mirror;
  mirror.refreshCurrent(context.dirty, slotsOf(pipelineOf(context), mirror));
  ContextState &state = *context.software;
  state.recorder.begin(mode, mirror.current);
  state.openParts = false;
  if (opensInParts(context, pipelineOf(context)))
    state.recorder.limit(kMostAtOnce, drawOpen, &context);
  return true;
}

void end(Context &context) {
  ContextState &state = *context.software;
  const VertexSource source = state.recorder.end();
  const std::uint32_t count = state.recorder.count();
  Outcome outcome;
  if (state.recorder.failed())
    outcome = Fallback::Memory;
  else if (count != 0)
    try {
      outcome = settled(context, [&] {
        return state.openParts ? drawInParts(context, pipelineOf(context), source, {.count = count})
                               : shadeAll(context, source, count);
      });
    } catch (const std::exception &) { // the attributes have been set whatever was drawn
      tellCurrentValues(context, state.recorder.values(), state.recorder.touched());
      throw;
    }
  if (!outcome.ok()) {
    replayFor(context, outcome.reason());
    context.host->End();
    if (state.recorder.failed())
      raise(context, GL_OUT_OF_MEMORY, "End: no memory for the primitive's vertices");
    return;
  }
  tellCurrentValues(context, state.recorder.values(), state.recorder.touched());
  if (!state.openParts)
    noteDrawn(context);
}

} // namespace arbiter::state::software
