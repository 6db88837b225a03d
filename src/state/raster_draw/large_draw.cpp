#include "state/raster_draw/large_draw.h"

#include <algorithm>
#include <new>

#include "state/core/context.h"
#include "state/raster_draw/context_state.h"

namespace arbiter::state::software {

namespace {

using swrast::Topology;

/// Vertices of a part: a multiple of those of all primitives, and even, so that each part of a
/// strip begins with a triangle that is wound as the first one is. So few that what the stages hand
/// on to each other stays in a processor's cache.
constexpr std::uint32_t kPart = 3u << 12;
static_assert(kMostOpen > kPart + 3 && kMostOpen < kMostAtOnce);

/// How primitives of a topology go on from one part to the next.
struct Joint {
  std::uint32_t shared = 0;             ///< last vertices of a part that are the next one's first
  bool pivots = false;                  ///< each primitive has the draw's first vertex
  bool closes = false;                  ///< a line leads from the last vertex to the first
  Topology topology = Topology::Points; ///< of a part
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

/// What is counted over a whole primitive has no parts: a stipple along lines, a polygon's sides.
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
  Parts(Context &context, Pipeline &pipeline, const VertexSource &source,
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
  Context &m_context;
  Pipeline &m_pipeline;
  const VertexSource &m_source;
  const VertexSequence &m_sequence;
  const Topology m_topology;
};

/// All vertices of the sequence are there, as far as is known where the arrays end.
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

Outcome drawInParts(Context &context, Pipeline &pipeline, const VertexSource &source,
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
      throw std::bad_alloc(); // what is drawn cannot be taken back
    }
  }
  if (joint.closes && !parts.draw({0, 1, true, sequence.count - 1}).ok())
    throw std::bad_alloc();
  return {};
}

bool opensInParts(const Context &context, const Pipeline &pipeline) {
  const Topology topology = pipeline.topology();
  // The line that closes a loop is the last one, and may come to be the host's.
  return !isWhole(context.software->mirror, topology) && !jointOf(topology).closes;
}

OpenPart openPart(const Pipeline &pipeline, std::uint32_t count) {
  const Joint joint = jointOf(pipeline.topology());
  const std::uint32_t lead = joint.pivots ? 1 : 0, around = lead + joint.shared;
  const std::uint32_t done = count < around ? 0 : (count - around) / kPart * kPart;
  return {around + done, lead, done};
}

} // namespace arbiter::state::software
