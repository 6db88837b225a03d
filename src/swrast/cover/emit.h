#pragma once
#include <algorithm>
#include <cstdint>

#include "swrast/cover/coverage.h"
#include "swrast/cover/flush_mode.h"
#include "swrast/cover/packed.h"

/// Shapes to spans and blocks, given to the shading function in batches.
namespace arbiter::swrast {

/// One thread's items of one primitive. Call flush() between primitives.
class Emitter {
public:
  Emitter(const RasterState &state, const Shading &shading)
      : m_state(state), m_shading(shading), m_blockSize{shading.blockWidth, shading.blockHeight},
        m_cover(chooseCoverKernels()), m_packed(state, shading) {}
  ~Emitter() { flush(); }
  Emitter(const Emitter &) = delete;
  Emitter &operator=(const Emitter &) = delete;

  /// What follows, until the end, lies in one tile: small triangles may wait for each other.
  void beginTile(const Rect &rect) {
    m_state.clears.reach(rect);
    m_packs = m_packed.begin(rect);
  }
  /// What of the shape lies in columns left to right and rows bottom to top.
  void shade(const Shape &shape, int left, int bottom, int right, int top);
  /// What of it lies in the rectangle, which is of the tile that has begun. It may wait, so that it
  /// stays where it is until the emitter's end.
  void shadeInTile(const Shape &shape, const Rect &rect);
  /// What of a small triangle lies in the rectangle, which is of one tile. Planes are made only if
  /// a pixel is covered. It stays where it is until the emitter's end, and its vertices do.
  void shadeSmall(const PlanePlan &plan, const WindowVertex *window, const SmallTriangle &small,
                  const Rect &rect);
  /// Shades the items that wait, but for those that wait for the tile's end.
  void flush();
  /// Pixels that were given to shading.
  [[nodiscard]] std::uint64_t pixels() const { return m_pixels; }

private:
  /// All 2x2 blocks of a tile of 64x64 pixels, and one that is written in vain.
  static constexpr std::uint32_t kBatch = 1025;

  void rows(const Shape &shape, int left, int bottom, int right, int top);
  void blocks(const Shape &shape, int left, int bottom, int right, int top);
  /// Gives the shape to what packs pixels, if it covers few of those of its blocks, or shades the
  /// blocks that were found. False: it is to be shaded otherwise.
  [[nodiscard]] bool pack(const Shape &shape, const Rect &part);
  /// What lies in a part of one tile.
  void tileBlocks(const Shape &shape, const Rect &part);
  /// The same of a shape whose edges do not fit 32 bits.
  void wideBlocks(const Shape &shape, const Rect &part);
  void span(int x, int y, int end);
  void stippledSpan(int x, int y, int end);
  /// Pixels of a block, row by row: a lane each.
  struct BlockSize {
    int width, height;
    [[nodiscard]] int lanes() const { return width * height; }
  };
  /// A packed tile's, whatever the shading function's.
  static constexpr BlockSize kPackedBlock = {4, 4};

  void block(int x, int y, unsigned mask, BlockSize size);
  /// The blocks in m_blocks, less what the shape's stipple leaves out, wait.
  void takeBlocks(const Shape &shape, const Cover &cover, BlockSize size);
  /// Takes what the rectangle or the stipple leaves out from the blocks of a small triangle.
  void keepInside(const Rect &rect, const Rect &part, BlockSize size);
  /// Leaves `maskOf(block)` of the blocks that wait, and what the stipple leaves of that.
  template <typename MaskOf> void filterBlocks(MaskOf maskOf, BlockSize size);
  [[nodiscard]] static unsigned insideMask(const Rect &rect, int x, int y, BlockSize size);
  [[nodiscard]] bool wantsRows(int width) const;
  /// Of small triangles, which rows cut into pieces of less than a vector.
  [[nodiscard]] bool wantsRowsOfSmall(int width) const;

  FlushMode m_mode;
  const RasterState &m_state;
  const Shading &m_shading;
  BlockSize m_blockSize; ///< of the shading function
  const CoverKernels &m_cover;
  PackedShader m_packed;
  bool m_packs = false;
  const abi::Primitive *m_primitive = nullptr;
  abi::Primitive m_small; ///< the small triangle's
  bool m_stippled = false;
  bool m_isRow = false;
  std::uint32_t m_count = 0;
  std::uint64_t m_pixels = 0;
  union {
    abi::Span m_spans[kBatch];
    abi::Block m_blocks[kBatch];
  };
};

/// The covered columns of a shape row by row, upwards: where an edge crosses a row is followed by
/// exact steps of quotient and remainder. Edges that do not cross what is walked cost nothing.
class RowWalker {
public:
  static constexpr int kRows = 64; ///< at a time

  RowWalker(const Shape &shape, int left, int bottom, int right, int top);
  /// The next `count` rows, at most kRows; begin >= end where nothing is covered.
  void next(int *begin, int *end, int count);

private:
  /// Of a left edge the first column that is covered, of a right one the first that is not.
  struct Walk {
    std::int64_t quotient, remainder, quotientStep, remainderStep, divisor;
  };
  struct Level { ///< a horizontal edge
    std::int64_t value, step;
  };
  /// Calls `put(row, column)`, with the column clamped to what is walked.
  template <typename Put> void follow(Walk &walk, int count, Put put) const;

  Walk m_walk[4]; ///< left edges from the front, right ones from the back
  Level m_level[4];
  int m_lefts = 0, m_rights = 0, m_levels = 0, m_left, m_right;
};

} // namespace arbiter::swrast
