#include "swrast/cover/chunk.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "swrast/cover/coverage.h"

namespace arbiter::swrast {
namespace {

/// The edges of a shape over a tile: is any pixel inside, are all?
struct TileTest {
  bool any = true, all = true;
};
TileTest testTile(const Shape &shape, const Rect &tile) {
  TileTest result;
  for (int i = 0; i < shape.edgeCount; ++i) {
    const EdgeOver edge(shape.edges[i], tile);
    result.any = result.any && edge.some;
    result.all = result.all && edge.all;
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

TileGrid TileGrid::of(const Rect &visible) {
  TileGrid grid;
  grid.clip = visible;
  grid.left = visible.x >> kTileShift;
  grid.bottom = visible.y >> kTileShift;
  grid.columns = ((visible.x + visible.width - 1) >> kTileShift) - grid.left + 1;
  grid.rows = ((visible.y + visible.height - 1) >> kTileShift) - grid.bottom + 1;
  return grid;
}

void Chunk::clear(const TileGrid &grid) {
  m_grid = grid;
  m_records.clear();
  m_links.clear();
  m_shapeCount = 0;
  m_area = 0;
  m_tiles.assign(grid.count(), List());
}

std::size_t Chunk::bytes() const {
  return m_records.capacity() * sizeof m_records[0] + m_shapes.capacity() * sizeof m_shapes[0] +
         m_links.capacity() * sizeof m_links[0] + m_tiles.capacity() * sizeof m_tiles[0];
}

void Chunk::link(int tileX, int tileY, bool covers) {
  List &list = m_tiles[std::size_t(tileY - m_grid.bottom) * std::size_t(m_grid.columns) +
                       std::size_t(tileX - m_grid.left)];
  const auto number = std::uint32_t(m_links.size());
  m_links.push_back({std::uint32_t(m_records.size() - 1), kNone});
  if (list.first == kNone || covers)
    list.first = number;
  else
    m_links[list.last].next = number;
  list.last = number;
  list.hidesOlder = list.hidesOlder || covers;
}

void Chunk::addShape(const Shape &shape, std::uint32_t inputs, bool hides) {
  if (m_shapeCount == m_shapes.size())
    m_shapes.emplace_back();
  static_assert(std::is_trivially_copyable_v<Shape>);
  constexpr std::size_t kFixed = offsetof(abi::Primitive, inputs);
  Shape &own = m_shapes[m_shapeCount];
  static_cast<Bounds &>(own) = shape;
  own.edgeCount = shape.edgeCount;
  own.stippled = shape.stippled;
  std::copy_n(shape.edges, shape.edgeCount, own.edges);
  std::memcpy(static_cast<void *>(&own.primitive), &shape.primitive,
              kFixed + inputs * sizeof(shape.primitive.inputs[0]));
  m_records.push_back({{std::uint32_t(m_shapeCount)}, 0, true, shape.primitive.backFacing != 0});
  ++m_shapeCount;
  m_area += std::uint64_t(shape.right - shape.left) * std::uint64_t(shape.top - shape.bottom);
  for (int y = shape.bottom >> TileGrid::kTileShift; y <= (shape.top - 1) >> TileGrid::kTileShift;
       ++y)
    for (int x = shape.left >> TileGrid::kTileShift; x <= (shape.right - 1) >> TileGrid::kTileShift;
         ++x) {
      const TileTest test = testTile(shape, m_grid.rect(x, y));
      if (test.any)
        link(x, y, hides && test.all);
    }
}

void Chunk::makeShape(const Draw &draw, const Triangle &triangle, Shape &shape) {
  const RasterState &state = draw.state;
  shape.stippled = state.polygonStipple != nullptr;
  makePlanes(state, draw.plan, triangle, state.offsetFill, shape.originX, shape.originY,
             shape.primitive);
  addShape(shape, draw.shading.inputCount, draw.shading.opaque && !shape.stippled);
}

void Chunk::add(const Draw &draw, Triangle &triangle, bool clip) {
  if (clip) {
    clipAndTake(draw, triangle,
                [&](const Triangle &part, Shape &shape) { makeShape(draw, part, shape); });
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
  if (!setBounds(m_grid.clip, v, 3, bounds))
    return;
  const auto extent = [](std::int32_t a, std::int32_t b, std::int32_t c) {
    return std::max({a, b, c}) - std::min({a, b, c});
  };
  if (extent(v[0].fixedX, v[1].fixedX, v[2].fixedX) >= kSmallExtent ||
      extent(v[0].fixedY, v[1].fixedY, v[2].fixedY) >= kSmallExtent) {
    Shape shape;
    if (shapeOf(m_grid.clip, v, area, shape))
      makeShape(draw, triangle, shape);
    return;
  }
  m_area += std::uint64_t(bounds.right - bounds.left) * std::uint64_t(bounds.top - bounds.bottom);
  m_records.push_back({{triangle.vertex[0], triangle.vertex[1], triangle.vertex[2]},
                       triangle.provoking,
                       false,
                       triangle.backFacing});
  constexpr int kShift = TileGrid::kTileShift;
  for (int y = bounds.bottom >> kShift; y <= (bounds.top - 1) >> kShift; ++y)
    for (int x = bounds.left >> kShift; x <= (bounds.right - 1) >> kShift; ++x)
      link(x, y, false);
}

template <Topology kTopology>
void Chunk::setUpAs(const Draw &draw, std::uint32_t first, std::uint32_t end) {
  const bool provokingIsFirst = provokesFirst(draw.state, kTopology);
  const Sight sight(m_grid.clip);
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
      add(draw, triangle, (any & kClipMask) != 0);
  }
}

void Chunk::setUp(const Draw &draw, std::uint32_t first, std::uint32_t end) {
  switch (draw.topology) {
  case Topology::Triangles:
    return setUpAs<Topology::Triangles>(draw, first, end);
  case Topology::TriangleStrip:
    return setUpAs<Topology::TriangleStrip>(draw, first, end);
  case Topology::TriangleFan:
    return setUpAs<Topology::TriangleFan>(draw, first, end);
  case Topology::Quads:
    return setUpAs<Topology::Quads>(draw, first, end);
  case Topology::QuadStrip:
    return setUpAs<Topology::QuadStrip>(draw, first, end);
  case Topology::Polygon:
    return setUpAs<Topology::Polygon>(draw, first, end);
  case Topology::Points:
  case Topology::Lines:
  case Topology::LineLoop:
  case Topology::LineStrip:
    return; // no triangles
  }
}

void Chunk::shade(std::size_t tile, const PlanePlan &plan, const WindowVertex *window,
                  const Rect &rect, Emitter &emitter) const {
  Triangle triangle;
  for (std::uint32_t at = m_tiles[tile].first; at != kNone; at = m_links[at].next) {
    const Record &record = m_records[m_links[at].record];
    if (record.isShape) {
      emitter.shadeInTile(m_shapes[record.vertex[0]], rect);
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      triangle.vertex[k] = record.vertex[k];
      triangle.corner[k] = window[record.vertex[k]];
    }
    triangle.provoking = record.provoking;
    triangle.backFacing = record.backFacing;
    emitter.shadeSmall(plan, triangle, rect);
  }
}

} // namespace arbiter::swrast
