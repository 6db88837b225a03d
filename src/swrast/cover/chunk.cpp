#include "swrast/cover/chunk.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "swrast/cover/coverage.h"

namespace arbiter::swrast {
namespace {

/// Tells whether any pixel of a tile, or all of them, are inside of the edges.
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

} // namespace

TileGrid TileGrid::of(const Rect &visible, const Rect &bounds) {
  TileGrid grid;
  grid.clip = visible;
  grid.bounds = bounds;
  grid.left = visible.x >> kTileShift;
  grid.bottom = visible.y >> kTileShift;
  grid.columns = ((visible.x + visible.width - 1) >> kTileShift) - grid.left + 1;
  grid.rows = ((visible.y + visible.height - 1) >> kTileShift) - grid.bottom + 1;
  return grid;
}

void Chunk::clear(const TileGrid &grid) {
  m_grid = grid;
  m_links.clear();
  m_smallCount = m_shapeCount = 0;
  m_area = 0;
  m_tiles.assign(grid.count(), List());
}

std::size_t Chunk::bytes() const {
  return m_small.capacity() * sizeof m_small[0] + m_shapes.capacity() * sizeof m_shapes[0] +
         m_links.capacity() * sizeof m_links[0] + m_tiles.capacity() * sizeof m_tiles[0];
}

void Chunk::link(int tileX, int tileY, std::uint32_t primitive, bool covers) {
  List &list = m_tiles[std::size_t(tileY - m_grid.bottom) * std::size_t(m_grid.columns) +
                       std::size_t(tileX - m_grid.left)];
  const auto number = std::uint32_t(m_links.size());
  m_links.push_back({primitive, kNone});
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
  const std::uint32_t primitive = Link::kShape | std::uint32_t(m_shapeCount++);
  m_area += std::uint64_t(shape.right - shape.left) * std::uint64_t(shape.top - shape.bottom);
  for (int y = shape.bottom >> TileGrid::kTileShift; y <= (shape.top - 1) >> TileGrid::kTileShift;
       ++y)
    for (int x = shape.left >> TileGrid::kTileShift; x <= (shape.right - 1) >> TileGrid::kTileShift;
         ++x) {
      const TileTest test = testTile(shape, m_grid.rect(x, y));
      if (test.any)
        link(x, y, primitive, hides && test.all);
    }
}

void Chunk::makeShape(const Draw &draw, const Triangle &triangle, Shape &shape) {
  const RasterState &state = draw.state;
  shape.stippled = state.polygonStipple != nullptr;
  makePlanes(state, draw.plan, triangle, state.offsetFill, shape.primitive);
  addShape(shape, draw.shading.inputCount, draw.shading.opaque && !shape.stippled);
}

void Chunk::addOther(const Draw &draw, const TriangleCorners &corners) {
  Triangle triangle;
  std::uint32_t any = 0;
  if (!fetchTriangle(draw, corners, triangle, any))
    return;
  if ((any & kClipMask) != 0) {
    clipAndTake(draw, triangle,
                [&](const Triangle &part, Shape &shape) { makeShape(draw, part, shape); });
    return;
  }
  const std::int64_t area = areaOf(triangle.corner);
  triangle.backFacing = isBackFacing(draw.state, area);
  Shape shape;
  if (area != 0 && !isCulled(draw.state, triangle.backFacing) &&
      shapeOf(m_grid.clip, triangle.corner, area, shape))
    makeShape(draw, triangle, shape);
}

void Chunk::linkSmall(std::uint32_t number) {
  const SmallTriangle &small = m_small[number];
  m_area += std::uint64_t(small.right - small.left) * std::uint64_t(small.top - small.bottom);
  constexpr int kShift = TileGrid::kTileShift;
  for (int y = small.bottom >> kShift; y <= (small.top - 1) >> kShift; ++y)
    for (int x = small.left >> kShift; x <= (small.right - 1) >> kShift; ++x)
      link(x, y, number, false);
}

void Chunk::addGroup(const Draw &draw, const SmallSetUp &with, const TriangleGroup &group,
                     const TriangleCorners *corners) {
  if (m_small.size() < m_smallCount + TriangleGroup::kMax)
    m_small.resize(std::max(2 * m_small.size(), m_smallCount + TriangleGroup::kMax));
  const GroupSetUp made = with.kernel(with, draw.window, group, m_small.data() + m_smallCount);
  for (unsigned rest = made.small | made.other; rest != 0; rest &= rest - 1) {
    const unsigned lane = rest & -rest;
    if (made.other & lane) {
      addOther(draw, corners[__builtin_ctz(rest)]);
      continue;
    }
    SmallTriangle &small = m_small[m_smallCount];
    if (made.depthless & lane) {
      const abi::DepthPlane plane = makeDepthPlane(
          draw.state, stepsOf(draw.state, small, draw.window), draw.state.offsetFill);
      const float depth[4] = {plane.c, plane.dx, plane.dy, plane.offset};
      std::copy_n(depth, 4, small.depth);
    }
    linkSmall(std::uint32_t(m_smallCount++));
  }
}

template <Topology kTopology>
void Chunk::setUpAs(const Draw &draw, std::uint32_t first, std::uint32_t end) {
  const bool provokingIsFirst = provokesFirst(draw.state, kTopology);
  const SmallSetUp with(draw.state, m_grid.clip);
  TriangleGroup group = {};
  TriangleCorners corners[TriangleGroup::kMax];
  for (std::uint32_t i = first; i < end; ++i) {
    TriangleCorners &own = corners[group.count];
    own = triangleAt(kTopology, draw.count, i, provokingIsFirst, draw.otherDiagonal);
    if (kTopology == Topology::Triangles && draw.provokingAt != 0)
      own.provoking = draw.provokingAt + i;
    bool isThere = true;
    const auto vertexAt = [&](std::uint32_t place) {
      const std::uint32_t vertex = draw.vertexAt(place);
      isThere = isThere && vertex < draw.vertices.count;
      return vertex;
    };
    for (int k = 0; k < 3; ++k)
      group.vertex[k][group.count] = vertexAt(own.corner[k]);
    group.provoking[group.count] = vertexAt(own.provoking);
    if (isThere && ++group.count == TriangleGroup::kMax) {
      addGroup(draw, with, group, corners);
      group.count = 0;
    }
  }
  if (group.count != 0) {
    // The kernel reads all lanes, so unused ones get a valid triangle.
    for (int lane = group.count; lane < TriangleGroup::kMax; ++lane)
      for (auto &vertex : group.vertex)
        vertex[lane] = vertex[0];
    addGroup(draw, with, group, corners);
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
    return; // these topologies have no triangles
  }
}

void Chunk::shade(std::size_t tile, const PlanePlan &plan, const WindowVertex *window,
                  const Rect &rect, Emitter &emitter) const {
  // Bounds snapped to tiles seldom cut blocks, and uncut blocks need no masking.
  constexpr int kTile = TileGrid::kTile, kMask = -kTile;
  const Rect bounds = intersect(m_grid.bounds, {rect.x & kMask, rect.y & kMask, kTile, kTile});
  for (std::uint32_t at = m_tiles[tile].first; at != kNone; at = m_links[at].next) {
    const std::uint32_t primitive = m_links[at].primitive;
    if (primitive & Link::kShape)
      emitter.shadeInTile(m_shapes[primitive & ~Link::kShape], rect);
    else
      emitter.shadeSmall(plan, window, m_small[primitive], bounds);
  }
}

} // namespace arbiter::swrast
