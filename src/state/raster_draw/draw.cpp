#include "state/raster_draw/draw.h"

#include "host/host_table.h"
#include "state/core/context.h"
#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/decision.h"
#include "state/raster_draw/immediate/list_arrays.h"
#include "state/raster_draw/large_draw.h"
#include "state/raster_draw/pipeline.h"
#include "state/raster_draw/vertices/array_source.h"

namespace arbiter::state::software {

namespace {

/// Keeps the arrays of one draw open, and closes them.
struct OpenArrays {
  OpenArrays(Context &inContext, ArraySource &ofSource) : context(inContext), source(ofSource) {}
  ~OpenArrays() { source.close(context); }
  OpenArrays(const OpenArrays &) = delete;
  OpenArrays &operator=(const OpenArrays &) = delete;
  Context &context;
  ArraySource &source;
};

/// Returns the slots that a draw reads, including edge flags. Requires that the pipeline has
/// chosen.
std::uint32_t slotsOf(const Pipeline &pipeline) {
  return std::uint32_t(pipeline.slots()) | 1u << kEdgeFlag;
}

/// True if a draw refused as mixed has arrays that the rasterizer lacks anyway. The draw then makes
/// the frame a mixed one, as it would if it had been tried (Units::judge()).
bool isHostsTurn(Context &context, const Outcome &outcome, const DrawCommand &command) {
  ContextState &state = *context.software;
  if (outcome.ok() || outcome.reason() != Fallback::Mixed || state.hostTurns != 0)
    return false;
  state.mirror.refreshArrays();
  return ArraySource::lacks(state.mirror, slotsOf(pipelineOf(context)), command);
}

Outcome drawFromArrays(Context &context, const DrawCommand &command) {
  Pipeline &pipeline = pipelineOf(context);
  Mirror &mirror = context.software->mirror;
  mirror.refreshArrays();
  const std::uint32_t slots = slotsOf(pipeline);
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

bool isIndexType(GLenum type) {
  return type == GL_UNSIGNED_INT || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_BYTE;
}

/// Draws arrays and returns true, or returns false with the host up to date. Requires
/// usesRasterizer(), a count above 0, and `first` of 0 or more.
bool drawArrays(Context &context, const DrawCommand &command) {
  return conclude(context, outcomeOf(context, [&] {
                    const Outcome outcome =
                        decide(context, command.mode, std::uint32_t(command.count));
                    if (isHostsTurn(context, outcome, command))
                      return Outcome(Fallback::Vertices);
                    return outcome.ok() ? drawFromArrays(context, command) : outcome;
                  }));
}

/// Leaves a multi-draw to the host, and notes it in an open list. Returns false.
bool leavesToHost(Context &context) {
  (void)isHosts(context);
  return false;
}

/// True if each draw of a multi-draw is decided on its own.
bool isEach(Context &context) {
  if (context.listMode != 0 && context.list->keeps())
    return true;
  return !isHosts(context) && usesRasterizer(context);
}

/// Draws or records one draw of a multi-draw. Returns false if the host must. Requires isEach().
bool takes(Context &context, const DrawCommand &command) {
  if (context.listMode == 0)
    return drawArrays(context, command);
  if (recordArrays(context, command))
    return true;
  context.list->notePixels();
  return false;
}

bool takesOrAliases(Context &context, const DrawCommand &command) {
  return command.count == 0 || takes(context, command) || aliasedDraw(context, command);
}

} // namespace

bool tryDraw(Context &context, const DrawCommand &command) {
  const bool draws = command.mode <= GL_POLYGON && command.count > 0 && command.first >= 0 &&
                     (command.indexType == 0 || isIndexType(command.indexType));
  if (context.listMode != 0 && draws) {
    if (recordArrays(context, command))
      return true;
    // arrays in a list of the host's may change current values (2.8)
    context.dirty |= dirty::kCurrent;
  }
  return !isHosts(context) && draws && usesRasterizer(context) && drawArrays(context, command);
}

bool tryDrawRange(Context &context, GLuint start, GLuint end, const DrawCommand &command) {
  return end >= start && tryDraw(context, command);
}

bool tryMultiDrawArrays(Context &context, GLenum mode, const GLint *first, const GLsizei *count,
                        GLsizei drawCount) {
  if (mode > GL_POLYGON || drawCount <= 0 || !first || !count)
    return leavesToHost(context);
  for (GLsizei i = 0; i < drawCount; ++i)
    if (first[i] < 0 || count[i] < 0)
      return leavesToHost(context);
  if (!isEach(context))
    return false;
  drawEach(context, {mode, first, count, drawCount}, takesOrAliases);
  return true;
}

bool tryMultiDrawElements(Context &context, GLenum mode, const GLsizei *count, GLenum type,
                          const void *const *indices, GLsizei drawCount,
                          const GLint *baseVertices) {
  if (mode > GL_POLYGON || drawCount <= 0 || !count || !indices || !isIndexType(type))
    return leavesToHost(context);
  for (GLsizei i = 0; i < drawCount; ++i)
    if (count[i] < 0)
      return leavesToHost(context);
  if (!isEach(context))
    return false;
  drawEach(context, {mode, nullptr, count, drawCount, type, indices, baseVertices}, takesOrAliases);
  return true;
}

Outcome drawSource(Context &context, const VertexSource &source, std::uint32_t count) {
  Pipeline &pipeline = pipelineOf(context);
  const VertexSequence sequence = {.count = count};
  if (isLarge(sequence)) [[unlikely]]
    return drawInParts(context, pipeline, source, sequence);
  return pipeline.shade(context, source, {}, 0, count);
}

} // namespace arbiter::state::software
