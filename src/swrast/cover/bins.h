#pragma once
#include <vector>

#include "swrast/cover/chunk.h"

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
  struct Part {
    Chunk chunk;
    bool usable = false; ///< there was memory for it
  };
  void shadeTile(const Draw &draw, const TileGrid &grid, std::uint32_t tile,
                 std::uint64_t &pixels) const;

  std::vector<Part> m_parts;
  std::uint32_t m_used = 0; ///< parts of this draw
};

} // namespace arbiter::swrast
