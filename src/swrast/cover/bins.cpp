#include "swrast/cover/bins.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <new>

#include "swrast/cover/small.h"
#include "swrast/threads.h"

namespace arbiter::swrast {
namespace {

/// The edges of a shape over a tile: is any pixel inside, are all?
struct TileTest {
  bool any = true, all = true;
};
TileTest testTile(const Shape &shape, const Rect &tile) {
  TileTest result;
  for (int i = 0; i < shape.edgeCount; ++i) {
    const Edge &edge = shape.edges[i];
    const std::int64_t at = std::int64_t(edge.a) * tile.x + std::int64_t(edge.b) * tile.y + edge.c;
    const std::int64_t alongX = std::int64_t(edge.a) * (tile.width - 1);
    const std::int64_t alongY = std::int64_t(edge.b) * (tile.height - 1);
    const std::int64_t zero = 0;
    result.any = result.any && at + std::max(alongX, zero) + std::max(alongY, zero) >= 0;
    result.all = result.all && at + std::min(alongX, zero) + std::min(alongY, zero) >= 0;
  }
  result.all = result.all && shape.left <= tile.x && shape.right >= tile.x + tile.width &&
               shape.bottom <= tile.y && shape.top >= tile.y + tile.height;
  return result;
}

/// What can be said of a triangle at a look at its corners.
class Sight {
public:
  explicit Sight(const Rect &clip)
      : m_first{clip.x, clip.y, 0, 0}, m_last{clip.x + clip.width - 1, clip.y + clip.height - 1, 0,
                                              0} {}
  /// False of one that is beyond a plane as a whole, or that has no pixel's centre of the clip
  /// rectangle within its bounds: what fetchTriangle() and setBounds() would say.
  [[nodiscard]] bool mayShow(const WindowVertex &a, const WindowVertex &b,
                             const WindowVertex &c) const {
    const std::uint32_t any = a.outcode | b.outcode | c.outcode;
    if (any != 0)
      return !(a.outcode & b.outcode & c.outcode & kOutsideMask);
    const Four p = placeOf(a), q = placeOf(b), r = placeOf(c);
    const Four least = lesser(lesser(p, q), r), most = greater(greater(p, q), r);
    const Four from = (least + (kSubpixels - 1)) >> kSubpixelBits, to = most >> kSubpixelBits;
    const Four none = (from > to) | (from > m_last) | (to < m_first);
    return (none[0] | none[1]) == 0;
  }

private:
  using Four = std::int32_t __attribute__((vector_size(16)));
  /// x and y, and something else.
  static Four placeOf(const WindowVertex &vertex) {
    Four place;
    static_assert(sizeof(WindowVertex) == 32 && offsetof(WindowVertex, fixedX) == 16);
    std::memcpy(&place, reinterpret_cast<const char *>(&vertex) + 16, sizeof place);
    return place;
  }
  static Four lesser(const Four &a, const Four &b) { return a < b ? a : b; }
  static Four greater(const Four &a, const Four &b) { return a > b ? a : b; }

  Four m_first, m_last; ///< pixels
};

} // namespace

Rect Bins::tileRect(std::uint32_t tile) const {
  const int x = m_left + int(tile) % m_tilesX, y = m_bottom + int(tile) / m_tilesX;
  return intersect(m_clip, {x << kTileShift, y << kTileShift, kTile, kTile});
}

void Bins::link(Chunk &chunk, int tileX, int tileY, bool covers) {
  List &list = chunk.tiles[std::size_t(tileY - m_bottom) * std::size_t(m_tilesX) +
                           std::size_t(tileX - m_left)];
  const auto number = std::uint32_t(chunk.links.size());
  chunk.links.push_back({std::uint32_t(chunk.records.size() - 1), kNone});
  if (list.first == kNone || covers)
    list.first = number;
  else
    chunk.links[list.last].next = number;
  list.last = number;
  list.hidesOlder = list.hidesOlder || covers;
}

void Bins::addShape(const Draw &draw, Chunk &chunk, const Triangle &triangle, Shape &shape) {
  const RasterState &state = draw.state;
  shape.stippled = state.polygonStipple != nullptr;
  makePlanes(state, draw.plan, triangle, state.offsetFill, shape.left, shape.bottom,
             shape.primitive);
  chunk.records.push_back({{std::uint32_t(chunk.shapes.size())}, 0, true, triangle.backFacing});
  chunk.shapes.push_back(shape);
  const bool hides = draw.shading.opaque && !shape.stippled;
  for (int y = shape.bottom >> kTileShift; y <= (shape.top - 1) >> kTileShift; ++y)
    for (int x = shape.left >> kTileShift; x <= (shape.right - 1) >> kTileShift; ++x) {
      const Rect tile = intersect(m_clip, {x << kTileShift, y << kTileShift, kTile, kTile});
      const TileTest test = testTile(shape, tile);
      if (test.any)
        link(chunk, x, y, hides && test.all);
    }
}

void Bins::add(const Draw &draw, Chunk &chunk, Triangle &triangle, bool clip) {
  if (clip) {
    clipAndTake(draw, triangle,
                [&](const Triangle &part, Shape &shape) { addShape(draw, chunk, part, shape); });
    return;
  }
  const WindowVertex *const v = triangle.corner;
  const std::int64_t area = areaOf(v);
  if (area == 0)
    return;
  triangle.backFacing = isBackFacing(draw.state, area);
  if (isCulled(draw.state, triangle.backFacing))
    return;
  Bounds bounds;
  if (!setBounds(m_clip, v, 3, bounds))
    return;
  const auto extent = [](std::int32_t a, std::int32_t b, std::int32_t c) {
    return std::max({a, b, c}) - std::min({a, b, c});
  };
  if (extent(v[0].fixedX, v[1].fixedX, v[2].fixedX) >= kSmallExtent ||
      extent(v[0].fixedY, v[1].fixedY, v[2].fixedY) >= kSmallExtent) {
    Shape shape;
    if (shapeOf(m_clip, v, area, shape))
      addShape(draw, chunk, triangle, shape);
    return;
  }
  chunk.records.push_back({{triangle.vertex[0], triangle.vertex[1], triangle.vertex[2]},
                           triangle.provoking,
                           false,
                           triangle.backFacing});
  for (int y = bounds.bottom >> kTileShift; y <= (bounds.top - 1) >> kTileShift; ++y)
    for (int x = bounds.left >> kTileShift; x <= (bounds.right - 1) >> kTileShift; ++x)
      link(chunk, x, y, false);
}

template <Topology kTopology>
void Bins::setUpAs(const Draw &draw, Chunk &chunk, std::uint32_t first, std::uint32_t end) {
  const bool provokingIsFirst = provokesFirst(draw.state, kTopology);
  const Sight sight(m_clip);
  for (std::uint32_t i = first; i < end; ++i) {
    const TriangleCorners corners =
        triangleAt(kTopology, draw.count, i, provokingIsFirst, draw.otherDiagonal);
    std::uint32_t vertex[3];
    bool isThere = true;
    for (int k = 0; k < 3; ++k) {
      vertex[k] = draw.vertexAt(corners.corner[k]);
      isThere = isThere && vertex[k] < draw.vertices.count;
    }
    if (!isThere ||
        !sight.mayShow(draw.window[vertex[0]], draw.window[vertex[1]], draw.window[vertex[2]]))
      continue;
    Triangle triangle;
    std::uint32_t any = 0;
    if (fetchTriangle(draw, corners, triangle, any))
      add(draw, chunk, triangle, (any & kClipMask) != 0);
  }
}

void Bins::setUp(const Draw &draw, Chunk &chunk, std::uint32_t first, std::uint32_t end) {
  chunk.records.clear();
  chunk.shapes.clear();
  chunk.links.clear();
  chunk.tiles.assign(std::size_t(m_tilesX) * std::size_t(m_tilesY), List());
  switch (draw.topology) {
  case Topology::Triangles:
    return setUpAs<Topology::Triangles>(draw, chunk, first, end);
  case Topology::TriangleStrip:
    return setUpAs<Topology::TriangleStrip>(draw, chunk, first, end);
  case Topology::TriangleFan:
    return setUpAs<Topology::TriangleFan>(draw, chunk, first, end);
  case Topology::Quads:
    return setUpAs<Topology::Quads>(draw, chunk, first, end);
  case Topology::QuadStrip:
    return setUpAs<Topology::QuadStrip>(draw, chunk, first, end);
  case Topology::Polygon:
    return setUpAs<Topology::Polygon>(draw, chunk, first, end);
  case Topology::Points:
  case Topology::Lines:
  case Topology::LineLoop:
  case Topology::LineStrip:
    return; // no triangles
  }
}

void Bins::shadeTile(const Draw &draw, std::uint32_t tile, std::uint64_t &pixels) {
  const Rect rect = tileRect(tile);
  std::uint32_t start = m_used;
  bool empty = true;
  while (start > 0) {
    if (!m_chunks[--start].usable)
      continue;
    const List &list = m_chunks[start].tiles[tile];
    empty = empty && list.first == kNone;
    if (list.hidesOlder)
      break;
  }
  if (empty)
    return;
  Emitter emitter(draw.state, draw.shading);
  emitter.beginTile(rect);
  Triangle triangle;
  for (std::uint32_t c = start; c < m_used; ++c) {
    const Chunk &chunk = m_chunks[c];
    if (!chunk.usable)
      continue;
    for (std::uint32_t at = chunk.tiles[tile].first; at != kNone; at = chunk.links[at].next) {
      const Record &record = chunk.records[chunk.links[at].record];
      if (record.isShape) {
        emitter.shade(chunk.shapes[record.vertex[0]], rect.x, rect.y, rect.x + rect.width,
                      rect.y + rect.height);
        continue;
      }
      for (int k = 0; k < 3; ++k) {
        triangle.vertex[k] = record.vertex[k];
        triangle.corner[k] = draw.window[record.vertex[k]];
      }
      triangle.provoking = record.provoking;
      triangle.backFacing = record.backFacing;
      emitter.shadeSmall(draw.plan, triangle, rect);
    }
  }
  pixels += emitter.pixels();
}

void Bins::shade(const Draw &draw, std::uint32_t first, std::uint32_t count,
                 DrawStatistics &statistics) {
  m_clip = draw.visible;
  if (m_clip.empty())
    return;
  m_left = m_clip.x >> kTileShift;
  m_bottom = m_clip.y >> kTileShift;
  m_tilesX = ((m_clip.x + m_clip.width - 1) >> kTileShift) - m_left + 1;
  m_tilesY = ((m_clip.y + m_clip.height - 1) >> kTileShift) - m_bottom + 1;
  m_used = (count + kChunk - 1) / kChunk;
  if (m_chunks.size() < m_used)
    m_chunks.resize(m_used);
  auto setUpChunk = [&](std::uint32_t i) {
    Chunk &chunk = m_chunks[i];
    chunk.usable = false;
    try {
      setUp(draw, chunk, first + i * kChunk, first + std::min(count, (i + 1) * kChunk));
      chunk.usable = true;
    } catch (const std::bad_alloc &) { // on a thread without a caller: it is not drawn, and said
    }
  };
  parallel(m_used, setUpChunk);
  std::atomic<std::uint64_t> pixels{0};
  auto tile = [&](std::uint32_t i) {
    std::uint64_t own = 0;
    shadeTile(draw, i, own);
    if (own)
      pixels.fetch_add(own, std::memory_order_relaxed);
  };
  parallel(std::uint32_t(m_tilesX) * std::uint32_t(m_tilesY), tile);
  statistics.pixels += pixels.load(std::memory_order_relaxed);
  for (std::uint32_t i = 0; i < m_used; ++i) {
    statistics.primitives += m_chunks[i].usable ? m_chunks[i].records.size() : 0;
    statistics.incomplete = statistics.incomplete || !m_chunks[i].usable;
  }
}

} // namespace arbiter::swrast
