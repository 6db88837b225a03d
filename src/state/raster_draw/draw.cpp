#include "state/raster_draw/draw.h"

#include "host/host_table.h"
#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/decision.h"
#include "state/raster_draw/immediate/list_arrays.h"
#include "state/raster_draw/large_draw.h"
#include "state/raster_draw/pipeline.h"
#include "state/raster_draw/raster_context.h"
#include "state/raster_draw/vertices/array_source.h"

namespace arbiter::state {

namespace {

/// Closes the arrays of a draw at the end of its scope, because the host cannot draw with them
/// open.
struct ArraysCloser {
  ArraysCloser(RasterContext &inContext, ArraySource &ofSource)
      : context(inContext), source(ofSource) {}
  ~ArraysCloser() { source.close(context); }
  ArraysCloser(const ArraysCloser &) = delete;
  ArraysCloser &operator=(const ArraysCloser &) = delete;
  RasterContext &context;
  ArraySource &source;
};

/// Returns the slots that a draw reads, including edge flags. Requires that decide() has chosen the
/// vertex function.
std::uint32_t slotsOf(const Pipeline &pipeline) {
  return std::uint32_t(pipeline.slots()) | 1u << kEdgeFlag;
}

/// True if a draw was refused only because the frames are mixed, and the rasterizer lacks its
/// arrays too. The arrays are then the reason. Otherwise a frame of such draws would look as if the
/// rasterizer could draw all of it, the next frame would be tried in vain, and frames would
/// alternate (ContextState::hostTurns).
bool alsoLacksArrays(RasterContext &context, const Outcome &outcome, const DrawCommand &command) {
  ContextState &state = *context.software;
  if (outcome.ok() || outcome.reason() != Fallback::Mixed || state.frame.hostTurns != 0)
    return false; // also if the frame is known to be mixed already
  state.mirror.refreshArrays();
  return ArraySource::lacks(state.mirror, slotsOf(pipelineOf(context)), command);
}

Outcome drawFromArrays(RasterContext &context, const DrawCommand &command) {
  Pipeline &pipeline = pipelineOf(context);
  Mirror &mirror = context.software->mirror;
  mirror.refreshArrays();
  const std::uint32_t slots = slotsOf(pipeline);
  ArraySource &arrays = pipeline.arrays();
  const ArraysCloser closer(context, arrays);
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

bool isIndexType(GLenum type) {
  return type == GL_UNSIGNED_INT || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_BYTE;
}

/// Draws arrays and returns true, or returns false with the host up to date. Requires
/// usesRasterizer(), a count above 0, and `first` of 0 or more.
bool drawArrays(RasterContext &context, const DrawCommand &command) {
  return conclude(context, outcomeOf(context, [&] {
                    const Outcome outcome =
                        decide(context, command.mode, std::uint32_t(command.count));
                    if (alsoLacksArrays(context, outcome, command))
                      return Outcome(Fallback::Vertices);
                    return outcome.ok() ? drawFromArrays(context, command) : outcome;
                  }));
}

/// Leaves a whole multi-draw to the host. Always returns false, for the caller to return.
bool leaveMultiDraw(RasterContext &context) {
  (void)executesPixels(context); // an open list notes the draw
  return false;
}

/// True if each draw of a multi-draw is decided on its own, and the layer calls the host for those
/// that the rasterizer does not draw.
bool decidesEach(RasterContext &context) {
  if (context.listMode != 0 && context.list->keeps())
    return true;
  return executesPixels(context) && usesRasterizer(context);
}

/// Draws or records one draw of a multi-draw. Returns false if the host must. Requires
/// decidesEach().
bool tryOne(RasterContext &context, const DrawCommand &command) {
  if (context.listMode == 0)
    return drawArrays(context, command);
  if (recordArrays(context, command))
    return true;
  context.list->notePixels();
  return false;
}

/// Like tryOne(), and also draws with the host if it would misread the arrays (aliasedDraw()). A
/// draw of no vertices is done at once.
bool tryOneOrAliased(RasterContext &context, const DrawCommand &command) {
  return command.count == 0 || tryOne(context, command) || aliasedDraw(context, command);
}

} // namespace

bool tryDraw(RasterContext &context, const DrawCommand &command) {
  const bool draws = command.mode <= GL_POLYGON && command.count > 0 && command.first >= 0 &&
                     (command.indexType == 0 || isIndexType(command.indexType));
  if (context.listMode != 0 && draws) {
    if (recordArrays(context, command))
      return true;
    // arrays in a list of the host's may change current values (2.8)
    context.dirty |= dirty::kCurrent;
  }
  return executesPixels(context) && draws && usesRasterizer(context) &&
         drawArrays(context, command);
}

bool tryDrawRange(RasterContext &context, GLuint start, GLuint end, const DrawCommand &command) {
  // An end before the start is an error, which the host raises.
  return end >= start && tryDraw(context, command);
}

bool tryMultiDrawArrays(RasterContext &context, GLenum mode, const GLint *first,
                        const GLsizei *count, GLsizei drawCount) {
  if (mode > GL_POLYGON || drawCount <= 0 || !first || !count)
    return leaveMultiDraw(context);
  for (GLsizei i = 0; i < drawCount; ++i)
    if (first[i] < 0 || count[i] < 0)
      return leaveMultiDraw(context);
  if (!decidesEach(context))
    return false;
  drawEach(context, {mode, first, count, drawCount}, tryOneOrAliased);
  return true;
}

bool tryMultiDrawElements(RasterContext &context, GLenum mode, const GLsizei *count, GLenum type,
                          const void *const *indices, GLsizei drawCount,
                          const GLint *baseVertices) {
  if (mode > GL_POLYGON || drawCount <= 0 || !count || !indices || !isIndexType(type))
    return leaveMultiDraw(context);
  for (GLsizei i = 0; i < drawCount; ++i)
    if (count[i] < 0)
      return leaveMultiDraw(context);
  if (!decidesEach(context))
    return false;
  drawEach(context, {mode, nullptr, count, drawCount, type, indices, baseVertices},
           tryOneOrAliased);
  return true;
}

Outcome drawSource(RasterContext &context, const VertexSource &source, std::uint32_t count) {
  Pipeline &pipeline = pipelineOf(context);
  const VertexSequence sequence = {.count = count};
  if (isLarge(sequence)) [[unlikely]]
    return drawInParts(context, pipeline, source, sequence);
  return pipeline.shade(context, source, {}, 0, count);
}

} // namespace arbiter::state
