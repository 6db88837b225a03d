#pragma once
#include <cstdint>
#include <vector>

#include "swrast/cover/emit.h"
#include "swrast/setup/triangles.h"

/// Primitives of a draw, set up and sorted into tiles of the window.
namespace arbiter::swrast {

/// The tiles that a draw may reach: those of pending clears, as a tile is one thread's.
struct TileGrid {
  static constexpr int kTileShift = DeferredClear::kTileShift, kTile = 1 << kTileShift;
  Rect clip; ///< pixels
  /// What primitives are cut off by: `clip` lies within it, closer around them all. No part of them
  /// lies between the two.
  Rect bounds;
  int left = 0, bottom = 0, columns = 0, rows = 0; ///< in tiles

  /// \param visible not empty
  [[nodiscard]] static TileGrid of(const Rect &visible) { return of(visible, visible); }
  [[nodiscard]] static TileGrid of(const Rect &visible, const Rect &bounds);
  [[nodiscard]] std::size_t count() const { return std::size_t(columns) * std::size_t(rows); }
  /// What is drawn of a tile: its pixels within the clip rectangle.
  [[nodiscard]] Rect rect(int x, int y) const {
    return intersect(clip, {x << kTileShift, y << kTileShift, kTile, kTile});
  }
};

/// So many primitives of a draw as one thread sets up at a time.
class Chunk {
public:
  static constexpr std::uint32_t kTriangles = 2048;

  /// Nothing is in it. Throws std::bad_alloc, as do all that add.
  void clear(const TileGrid &grid);
  /// Sets up triangles [first, end) of the draw.
  void setUp(const Draw &draw, std::uint32_t first, std::uint32_t end);
  /// Adds a shape whose planes are made.
  /// \param hides it replaces whatever lies below its pixels
  /// \param inputs so many of its inputs are used
  void addShape(const Shape &shape, std::uint32_t inputs, bool hides);

  [[nodiscard]] const TileGrid &grid() const { return m_grid; }
  [[nodiscard]] std::uint32_t primitives() const {
    return std::uint32_t(m_smallCount + m_shapeCount);
  }
  /// Times that a primitive is looked at in a tile.
  [[nodiscard]] std::uint32_t links() const { return std::uint32_t(m_links.size()); }
  /// Vertices are read when tiles are shaded.
  [[nodiscard]] bool readsVertices() const { return m_smallCount != 0; }
  /// Pixels within the bounds of all primitives.
  [[nodiscard]] std::uint64_t area() const { return m_area; }
  /// Memory that it keeps for the next draw.
  [[nodiscard]] std::size_t bytes() const;
  /// Tile number y * columns + x of the grid, from its corner.
  [[nodiscard]] bool isEmpty(std::size_t tile) const { return m_tiles[tile].first == kNone; }
  /// The first primitive in the tile is opaque and covers it.
  [[nodiscard]] bool hidesOlder(std::size_t tile) const { return m_tiles[tile].hidesOlder; }
  /// Shades what lies in the tile, in order.
  /// \param rect what of the tile is drawn to; `emitter` has begun it
  void shade(std::size_t tile, const PlanePlan &plan, const WindowVertex *window, const Rect &rect,
             Emitter &emitter) const;

private:
  static constexpr std::uint32_t kNone = ~0u;
  struct Link {
    static constexpr std::uint32_t kShape = 1u << 31;
    std::uint32_t primitive; ///< the number of a small triangle, or kShape and that of a shape
    std::uint32_t next;
  };
  struct List {
    std::uint32_t first = kNone, last = kNone;
    bool hidesOlder = false; ///< the first is opaque and covers the tile
  };

  template <Topology kTopology>
  void setUpAs(const Draw &draw, std::uint32_t first, std::uint32_t end);
  /// Sets up the triangles that were collected, of which the places in the draw are known.
  void addGroup(const Draw &draw, const SmallSetUp &with, const TriangleGroup &group,
                const TriangleCorners *corners);
  /// A triangle that is clipped or not small.
  void addOther(const Draw &draw, const TriangleCorners &corners);
  void linkSmall(std::uint32_t number);
  void makeShape(const Draw &draw, const Triangle &triangle, Shape &shape);
  void link(int tileX, int tileY, std::uint32_t primitive, bool covers);

  TileGrid m_grid;
  // Elements behind the counts are those of earlier draws: written over, not made anew.
  std::vector<SmallTriangle> m_small;
  std::vector<Shape> m_shapes;
  std::size_t m_smallCount = 0, m_shapeCount = 0;
  std::vector<Link> m_links;
  std::vector<List> m_tiles;
  std::uint64_t m_area = 0;
};

} // namespace arbiter::swrast
