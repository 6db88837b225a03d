#include "state/raster_draw/large_draw.h"

#include <algorithm>
#include <new>

#include "state/raster_draw/context_state.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

using swrast::Topology;

/// Vertices of a part. It is a multiple of the size of every primitive, and even, so that each part
/// of a strip begins with the winding of the first triangle. It is small enough that data between
/// the stages stays in a processor's cache.
constexpr std::uint32_t kPart = 3u << 12;
static_assert(kMaxOpen > kPart + 3 && kMaxOpen < kMaxAtOnce);

/// How primitives of a topology continue from one part to the next.
struct Joint {
  std::uint32_t shared = 0; ///< number of last vertices of a part that begin the next part
  bool pivots = false;      ///< true if each primitive has the draw's first vertex
  bool closes = false;      ///< true if a line joins the last vertex to the first
  Topology topology = Topology::Points; ///< topology of a part
};
Joint jointOf(Topology topology) {
  switch (topology) {
  case Topology::LineStrip:
    return {1, false, false, topology};
  case Topology::LineLoop:
    return {1, false, true, Topology::LineStrip};
  case Topology::TriangleStrip:
  case Topology::QuadStrip:
    return {2, false, false, topology};
  case Topology::TriangleFan:
  case Topology::Polygon:
    return {1, true, false, topology};
  default:
    return {0, false, false, topology};
  }
}

/// True if a draw cannot be split: a line stipple runs along all lines, and an unfilled polygon
/// needs its own sides.
bool isWhole(const Mirror &mirror, Topology topology) {
  const swrast::RasterState &state = mirror.raster;
  if (topology == Topology::LineStrip || topology == Topology::LineLoop)
    return state.lineStippleFactor != 0;
  return topology == Topology::Polygon &&
         (state.front != swrast::PolygonMode::Fill || state.back != swrast::PolygonMode::Fill);
}

/// Draws parts of one sequence.
class Parts {
public:
  Parts(RasterContext &context, Pipeline &pipeline, const VertexSource &source,
        const VertexSequence &sequence, Topology topology)
      : m_context(context), m_pipeline(pipeline), m_source(source), m_sequence(sequence),
        m_topology(topology) {}

  Outcome draw(const SequencePart &part) {
    if (m_sequence.indexType == 0 && !part.pivots)
      return m_pipeline.shadePart(m_context, m_source, {}, m_sequence.first + part.begin,
                                  part.count, m_topology);
    IndexRange range;
    VertexFetcher &fetcher = m_pipeline.fetcher();
    const std::int32_t base =
        m_sequence.indexType != 0 ? m_sequence.baseVertex : std::int32_t(m_sequence.first);
    if (!fetcher.decodePart(m_sequence.indexType, m_sequence.indices, part, base, range))
      return Fallback::Memory;
    VertexSource source = m_source;
    if (VertexFetcher::isSparse(range) &&
        !fetcher.compact(source, m_pipeline.slots() | 1u << kEdgeFlag, range))
      return Fallback::Memory;
    return m_pipeline.shadePart(m_context, source, range, 0, range.count, m_topology);
  }

private:
  RasterContext &m_context;
  Pipeline &m_pipeline;
  const VertexSource &m_source;
  const VertexSequence &m_sequence;
  const Topology m_topology;
};

/// True if all vertices of the sequence exist, as far as the ends of the arrays are known.
bool isWithin(const VertexSource &source, const VertexSequence &sequence) {
  IndexBounds bounds{sequence.first, std::int64_t(sequence.first) + sequence.count - 1};
  if (sequence.indexType != 0) {
    if (!boundsOf(sequence.indexType, sequence.indices, sequence.count, bounds))
      return false;
    bounds.minimum += sequence.baseVertex;
    bounds.maximum += sequence.baseVertex;
  }
  return bounds.minimum >= 0 && bounds.maximum <= std::int64_t(INT32_MAX) &&
         (source.count == 0 || bounds.maximum < std::int64_t(source.count));
}

} // namespace

Outcome drawInParts(RasterContext &context, Pipeline &pipeline, const VertexSource &source,
                    const VertexSequence &sequence) {
  const Topology topology = pipeline.topology();
  if (isWhole(context.software->mirror, topology))
    return Fallback::State;
  if (!isWithin(source, sequence))
    return Fallback::Vertices;
  const Joint joint = jointOf(topology);
  Parts parts(context, pipeline, source, sequence, joint.topology);
  const std::uint32_t lead = joint.pivots ? 1 : 0;
  for (std::uint32_t begin = lead; begin + joint.shared < sequence.count; begin += kPart) {
    const std::uint32_t count = std::min(kPart + joint.shared, sequence.count - begin);
    if (const Outcome outcome = parts.draw({begin, count, joint.pivots, 0}); !outcome.ok()) {
      if (begin == lead)
        return outcome;
      throw std::bad_alloc(); // parts that were drawn cannot be undone
    }
  }
  if (joint.closes && !parts.draw({0, 1, true, sequence.count - 1}).ok())
    throw std::bad_alloc();
  return {};
}

bool opensInParts(const RasterContext &context, const Pipeline &pipeline) {
  const Topology topology = pipeline.topology();
  // The last line of a loop closes it, and might have to be the host's.
  return !isWhole(context.software->mirror, topology) && !jointOf(topology).closes;
}

OpenPart openPart(const Pipeline &pipeline, std::uint32_t count) {
  const Joint joint = jointOf(pipeline.topology());
  const std::uint32_t lead = joint.pivots ? 1 : 0, around = lead + joint.shared;
  const std::uint32_t done = count < around ? 0 : (count - around) / kPart * kPart;
  return {around + done, lead, done};
}

} // namespace arbiter::state
