#pragma once
#include <algorithm>
#include <cstdint>

#include "swrast/cover/coverage.h"
#include "swrast/cover/flush_mode.h"
#include "swrast/cover/packed.h"

/// Converts shapes to spans and blocks, and passes them to the shading function in batches.
namespace arbiter::swrast {

/// Collects one thread's spans or blocks of one primitive. Call flush() between primitives.
class Emitter {
public:
  Emitter(const RasterState &state, const Shading &shading)
      : m_state(state), m_shading(shading), m_blockSize{shading.blockWidth, shading.blockHeight},
        m_cover(chooseCoverKernels()), m_packed(state, shading) {}
  ~Emitter() { flush(); }
  Emitter(const Emitter &) = delete;
  Emitter &operator=(const Emitter &) = delete;

  /// Begins a tile. Everything drawn from here to the end must lie in it, and small triangles may
  /// be deferred.
  void beginTile(const Rect &rect) {
    m_state.clears.reach(rect);
    m_packs = m_packed.begin(rect);
  }
  /// Shades the part of the shape in columns left to right and rows bottom to top.
  void shade(const Shape &shape, int left, int bottom, int right, int top);
  /// Shades the part of the shape in the rectangle, which belongs to the tile that was begun.
  /// Shading may be deferred, so the shape must stay valid until the emitter's end.
  void shadeInTile(const Shape &shape, const Rect &rect);
  /// Shades the part of a small triangle in the rectangle, which lies in one tile. Its planes are
  /// computed only if a pixel is covered. The triangle and its vertices must stay valid until the
  /// emitter's end.
  void shadeSmall(const PlanePlan &plan, const WindowVertex *window, const SmallTriangle &small,
                  const Rect &rect);
  /// Shades the collected items, but not the triangles deferred to the tile's end.
  void flush();
  /// Returns the number of pixels passed to shading.
  [[nodiscard]] std::uint64_t pixels() const { return m_pixels; }

private:
  /// Room for all 2x2 blocks of a tile of 64x64 pixels, and for one block that is written but not
  /// kept.
  static constexpr std::uint32_t kBatch = 1025;

  void rows(const Shape &shape, int left, int bottom, int right, int top);
  void blocks(const Shape &shape, int left, int bottom, int right, int top);
  /// Handles a shape by blocks: passes it to the packed shader if it covers few pixels of its
  /// blocks, or shades the blocks found. Returns false if neither suits the shape.
  [[nodiscard]] bool pack(const Shape &shape, const Rect &part);
  /// Shades the part of a shape in one tile by blocks.
  void tileBlocks(const Shape &shape, const Rect &part);
  /// Shades a part whose edges do not fit 32 bits.
  void wideBlocks(const Shape &shape, const Rect &part);
  void span(int x, int y, int end);
  void stippledSpan(int x, int y, int end);
  /// A block's size in pixels. Each pixel is a lane, row by row.
  struct BlockSize {
    int width, height;
    [[nodiscard]] int lanes() const { return width * height; }
  };
  /// The block size of a packed tile, independent of the shading function.
  static constexpr BlockSize kPackedBlock = {4, 4};

  void block(int x, int y, unsigned mask, BlockSize size);
  /// Keeps the found blocks in m_blocks for shading, less the pixels that the shape's stipple
  /// removes.
  void takeBlocks(const Shape &shape, const Cover &cover, BlockSize size);
  /// Removes the pixels outside the rectangle or the stipple from a small triangle's blocks.
  void keepInside(const Rect &rect, const Rect &part, BlockSize size);
  /// Replaces the masks of the collected blocks by `maskOf(block)`, less the stipple.
  template <typename MaskOf> void filterBlocks(MaskOf maskOf, BlockSize size);
  [[nodiscard]] static unsigned insideMask(const Rect &rect, int x, int y, BlockSize size);
  [[nodiscard]] bool wantsRows(int width) const;
  /// True if small triangles are shaded by rows, which are shorter than a vector.
  [[nodiscard]] bool wantsRowsOfSmall(int width) const;

  FlushMode m_mode;
  const RasterState &m_state;
  const Shading &m_shading;
  BlockSize m_blockSize; ///< the shading function's block size
  const CoverKernels &m_cover;
  PackedShader m_packed;
  bool m_packs = false;
  const abi::Primitive *m_primitive = nullptr;
  abi::Primitive m_small; ///< the planes of the small triangle being shaded
  bool m_stippled = false;
  bool m_isRow = false;
  std::uint32_t m_count = 0;
  std::uint64_t m_pixels = 0;
  union {
    abi::Span m_spans[kBatch];
    abi::Block m_blocks[kBatch];
  };
};

/// Finds the covered columns of a shape, row by row upwards. The column where an edge crosses a row
/// is stepped exactly, as a quotient and a remainder. Edges that do not cross the walked area cost
/// nothing.
class RowWalker {
public:
  static constexpr int kRows = 64; ///< most rows in one call of next()

  RowWalker(const Shape &shape, int left, int bottom, int right, int top);
  /// Computes the next `count` rows, at most kRows. A row without covered pixels has begin >= end.
  void next(int *begin, int *end, int count);

private:
  /// The column of an edge: the first covered one for a left edge, the first uncovered one for a
  /// right edge.
  struct Walk {
    std::int64_t quotient, remainder, quotientStep, remainderStep, divisor;
  };
  struct Level { ///< a horizontal edge
    std::int64_t value, step;
  };
  /// Calls `put(row, column)` for each row, with the column clamped to the walked area.
  template <typename Put> void follow(Walk &walk, int count, Put put) const;

  Walk m_walk[4]; ///< left edges from the front, right edges from the back
  Level m_level[4];
  int m_lefts = 0, m_rights = 0, m_levels = 0, m_left, m_right;
};

} // namespace arbiter::swrast
