#pragma once
#include <vector>

#include "swrast/cover/emit.h"
#include "swrast/setup/triangles.h"

/// Many triangles at a time: they are set up in chunks, sorted into tiles of the window, and each
/// tile is shaded by one thread, in the order of the draw.
namespace arbiter::swrast {

class Bins {
public:
  /// Shades `count` triangles of the draw from number `first` on, at most kMaxTriangles.
  void shade(const Draw &draw, std::uint32_t first, std::uint32_t count,
             DrawStatistics &statistics);
  static constexpr std::uint32_t kMaxTriangles = 1 << 15;

private:
  /// Those of pending clears: a tile is one thread's.
  static constexpr int kTileShift = DeferredClear::kTileShift, kTile = 1 << kTileShift;
  static constexpr std::uint32_t kChunk = 2048; ///< triangles
  static constexpr std::uint32_t kNone = ~0u;

  /// A small triangle as vertices; of another, `vertex[0]` is the number of its shape.
  struct Record {
    std::uint32_t vertex[3];
    std::uint32_t provoking;
    bool isShape, backFacing;
  };
  struct Link {
    std::uint32_t record, next;
  };
  struct List {
    std::uint32_t first = kNone, last = kNone;
    bool hidesOlder = false; ///< the first is opaque and covers the tile
  };
  struct Chunk {
    std::vector<Record> records;
    std::vector<Shape> shapes;
    std::vector<Link> links;
    std::vector<List> tiles;
    bool usable = false; ///< there was memory for it
  };

  void setUp(const Draw &draw, Chunk &chunk, std::uint32_t first, std::uint32_t end);
  template <Topology kTopology>
  void setUpAs(const Draw &draw, Chunk &chunk, std::uint32_t first, std::uint32_t end);
  void add(const Draw &draw, Chunk &chunk, Triangle &triangle, bool clip);
  void addShape(const Draw &draw, Chunk &chunk, const Triangle &triangle, Shape &shape);
  void link(Chunk &chunk, int tileX, int tileY, bool covers);
  void shadeTile(const Draw &draw, std::uint32_t tile, std::uint64_t &pixels);
  [[nodiscard]] Rect tileRect(std::uint32_t tile) const;

  std::vector<Chunk> m_chunks;
  std::uint32_t m_used = 0; ///< chunks of this draw
  Rect m_clip;
  int m_left = 0, m_bottom = 0, m_tilesX = 0, m_tilesY = 0; ///< in tiles
};

} // namespace arbiter::swrast
