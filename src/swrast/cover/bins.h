#pragma once
#include <vector>

#include "swrast/cover/chunk.h"

/// Draws many triangles. They are set up in chunks and sorted into tiles of the window. One thread
/// shades a tile, in the order of the draw.
namespace arbiter::swrast {

class Bins {
public:
  /// Shades `count` triangles of the draw from number `first` on. Requires count <= kMaxTriangles.
  void shade(const Draw &draw, std::uint32_t first, std::uint32_t count,
             DrawStatistics &statistics);
  static constexpr std::uint32_t kMaxTriangles = 1 << 15;

private:
  struct Part {
    Chunk chunk;
    bool usable = false; ///< false if memory ran out for it
  };
  void shadeTile(const Draw &draw, const TileGrid &grid, std::uint32_t tile,
                 std::uint64_t &pixels) const;

  std::vector<Part> m_parts;
  std::uint32_t m_used = 0; ///< number of parts in this draw
};

} // namespace arbiter::swrast
