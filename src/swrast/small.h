#pragma once
#include "swrast/setup.h"

/// Coverage of small triangles, block by block.
namespace arbiter::swrast {

/// Triangles whose snapped corners are less than this apart, in x and in y: their edge functions
/// fit 32 bits near them.
inline constexpr std::int32_t kSmallExtent = 64 * kSubpixels;

/// Edge functions at the pixels of a block, moved from block to block.
class BlockWalker {
public:
  /// (x, y): the lower left pixel of a block no farther from the triangle than its extent.
  BlockWalker(const WindowVertex corner[3], bool counterclockwise, int x, int y, int blockWidth,
              int lanes);
  /// The mask of the block that lies dx, dy pixels from the first.
  [[nodiscard]] unsigned mask(int dx, int dy) const;

private:
  using Int4 = std::int32_t __attribute__((vector_size(16)));
  Int4 m_lane[3][4]; ///< edges at the first block's pixels
  std::int32_t m_a[3], m_b[3];
  int m_vectors;
};

} // namespace arbiter::swrast
