#pragma once
#include <cstdint>
#include <vector>

#include "swrast/cover/emit.h"
#include "swrast/setup/triangles.h"

/// Primitives of a draw, set up and sorted into tiles of the window.
namespace arbiter::swrast {

/// The grid of tiles that a draw may reach. It matches the tiles of pending clears, because one
/// thread owns a tile.
struct TileGrid {
  static constexpr int kTileShift = DeferredClear::kTileShift, kTile = 1 << kTileShift;
  Rect clip; ///< the pixels to draw
  /// The rectangle that primitives are clipped to. It contains `clip`; no primitive has pixels
  /// between the two.
  Rect bounds;
  int left = 0, bottom = 0, columns = 0, rows = 0; ///< in tiles

  /// Returns the grid of a rectangle. \param visible must not be empty
  [[nodiscard]] static TileGrid of(const Rect &visible) { return of(visible, visible); }
  [[nodiscard]] static TileGrid of(const Rect &visible, const Rect &bounds);
  [[nodiscard]] std::size_t count() const { return std::size_t(columns) * std::size_t(rows); }
  /// Returns the pixels of a tile that lie within the clip rectangle.
  [[nodiscard]] Rect rect(int x, int y) const {
    return intersect(clip, {x << kTileShift, y << kTileShift, kTile, kTile});
  }
};

/// As many primitives of a draw as one thread sets up at a time.
class Chunk {
public:
  static constexpr std::uint32_t kTriangles = 2048;

  /// Empties the chunk. Like all functions that add primitives, it may throw std::bad_alloc.
  void clear(const TileGrid &grid);
  /// Sets up triangles [first, end) of the draw and adds them.
  void setUp(const Draw &draw, std::uint32_t first, std::uint32_t end);
  /// Adds a shape whose planes have been computed.
  /// \param hides true if it replaces everything below its pixels
  /// \param inputs number of inputs in use
  void addShape(const Shape &shape, std::uint32_t inputs, bool hides);

  [[nodiscard]] const TileGrid &grid() const { return m_grid; }
  [[nodiscard]] std::uint32_t primitives() const {
    return std::uint32_t(m_smallCount + m_shapeCount);
  }
  /// Returns the number of pairs of a primitive and a tile that it may reach.
  [[nodiscard]] std::uint32_t links() const { return std::uint32_t(m_links.size()); }
  /// True if shading a tile will read vertices.
  [[nodiscard]] bool readsVertices() const { return m_smallCount != 0; }
  /// Returns the sum of the areas of all primitives' bounding boxes, in pixels.
  [[nodiscard]] std::uint64_t area() const { return m_area; }
  /// Returns the bytes that the chunk keeps allocated for later draws.
  [[nodiscard]] std::size_t bytes() const;
  /// True if no primitive reaches the tile. Tile (x, y) has number y * columns + x, counted from
  /// the grid's corner.
  [[nodiscard]] bool isEmpty(std::size_t tile) const { return m_tiles[tile].first == kNone; }
  /// True if the tile's first primitive is opaque and covers the tile.
  [[nodiscard]] bool hidesOlder(std::size_t tile) const { return m_tiles[tile].hidesOlder; }
  /// Shades the tile's primitives in order.
  /// \param rect the pixels of the tile to draw; `emitter` has begun this rectangle
  void shade(std::size_t tile, const PlanePlan &plan, const WindowVertex *window, const Rect &rect,
             Emitter &emitter) const;

private:
  static constexpr std::uint32_t kNone = ~0u;
  struct Link {
    static constexpr std::uint32_t kShape = 1u << 31;
    std::uint32_t primitive; ///< number of a small triangle, or kShape plus the number of a shape
    std::uint32_t next;
  };
  struct List {
    std::uint32_t first = kNone, last = kNone;
    bool hidesOlder = false; ///< true if the first primitive is opaque and covers the tile
  };

  template <Topology kTopology>
  void setUpAs(const Draw &draw, std::uint32_t first, std::uint32_t end);
  /// Sets up a group of triangles. The corners tell their vertices' places in the draw.
  void addGroup(const Draw &draw, const SmallSetUp &with, const TriangleGroup &group,
                const TriangleCorners *corners);
  /// Adds a triangle that needs clipping or is not small.
  void addOther(const Draw &draw, const TriangleCorners &corners);
  void linkSmall(std::uint32_t number);
  void makeShape(const Draw &draw, const Triangle &triangle, Shape &shape);
  void link(int tileX, int tileY, std::uint32_t primitive, bool covers);

  TileGrid m_grid;
  // The vectors are never shrunk: elements beyond the counts are reused, which saves constructing
  // them.
  std::vector<SmallTriangle> m_small;
  std::vector<Shape> m_shapes;
  std::size_t m_smallCount = 0, m_shapeCount = 0;
  std::vector<Link> m_links;
  std::vector<List> m_tiles;
  std::uint64_t m_area = 0;
};

} // namespace arbiter::swrast
