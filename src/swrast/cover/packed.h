#pragma once
#include <cstdint>

#include "swrast/setup/planes.h"
#include "swrast/setup/shape.h"
#include "swrast/setup/small.h"

/// Draws small and thin primitives by the pixel. The rasterizer tests depth itself, in a copy of
/// the tile that stays in the processor's nearest cache. The machine code gets full vectors of the
/// pixels that passed.
///
/// If fragments replace what is there, a tile is shaded after all its triangles have been tested.
/// Then each pixel is shaded once, however many triangles overlap, and pixels of several triangles
/// share a vector.
namespace arbiter::swrast {

/// The depths and owners of a tile of 64x64 pixels, as consecutive blocks of 4x4. The lane of a
/// pixel is 4 * row + column of its block.
struct PackedTile {
  static constexpr int kSide = 64, kBlocks = 256, kLanes = 16;
  alignas(64) std::int32_t depth[kBlocks][kLanes]; ///< pixels of the depth buffer
  /// number of the triangle visible there; 0: none
  alignas(64) std::uint32_t owner[kBlocks][kLanes];
  /// Window coordinates of the pixels in each column and each row of blocks; y is relative to the
  /// row where planes begin. The depth tests of all triangles use them.
  alignas(64) float xOf[kSide / 4][kLanes], yOf[kSide / 4][kLanes];
  std::uint16_t loaded[kBlocks / 16]; ///< bit of a block: its depths and owners are filled
  Rect rect;                          ///< visible part of the tile
  int originY;                        ///< row where planes begin
  abi::Target target;                 ///< the depth buffer
  DepthTest test;
  float minimum, maximum; ///< range that depth is clamped to

  /// Returns a block's index. Always inline, because it is compiled for several instruction sets.
  [[nodiscard, gnu::always_inline]] static inline unsigned blockAt(int x, int y) {
    return (unsigned(y) >> 2 & 15) << 4 | (unsigned(x) >> 2 & 15);
  }
  /// Returns the position of a block's first pixel, packed as in abi::Pixel.
  [[nodiscard, gnu::always_inline]] static inline int placeOf(const abi::Block &block) {
    return (block.y & (kSide - 1)) << 8 | (block.x & (kSide - 1));
  }
  /// Begins a tile. \param planesFrom row where all planes begin
  void begin(const Rect &tile, const Shading &shading, int planesFrom);
  /// Fills a block from the depth buffer, without any owner.
  void load(int x, int y);
  /// Writes the depths back if the test writes them, and empties the tile.
  void end();

private:
  template <typename Visit> void eachPixel(int x, int y, Visit visit) const;
};

/// Tests the blocks of a triangle against the tile. Passing pixels are written and get the owner
/// `owner`; blocks with passing pixels are listed in `out`.
/// \param out room for `count` and one more; may be `blocks`
/// \return the number of blocks listed
using TestBlocks = std::uint32_t (*)(PackedTile &tile, const abi::DepthPlane &z,
                                     std::uint32_t owner, const abi::Block *blocks,
                                     std::uint32_t count, abi::Block *out);
/// A triangle or another shape that waits to be shaded, with the blocks that passed the depth test.
struct PackedTriangle {
  const abi::Primitive *made; ///< its planes; null: they are computed from the next three members
  const PlanePlan *plan;
  const SmallTriangle *small;
  const WindowVertex *window; ///< the draw's vertices
  std::uint32_t inputs;       ///< number of inputs in `made`
  std::uint32_t count;        ///< number of its blocks
  abi::DepthPlane depth;
};

/// Lists the pixels of blocks consecutively, for the primitive in `column`. If `owner` is not 0,
/// only the pixels that it still owns are listed. If `quads` is true, quads are completed with
/// helper pixels.
/// \param out room for 16 pixels more than the blocks have
/// \return the number of pixels listed
using ListPixels = std::uint32_t (*)(const PackedTile &tile, std::uint32_t owner, unsigned column,
                                     bool quads, const abi::Block *blocks, std::uint32_t count,
                                     abi::Pixel *out);
/// Computes the columns with which `count` triangles are shaded; the first triangle's is column 0.
using SetColumns = void (*)(const RasterState &state, const PackedTriangle *const *triangles,
                            int count, abi::PrimitiveColumns &columns);
struct PackedKernels {
  TestBlocks (*test)(const DepthTest &); ///< returns the function for a depth test
  ListPixels list;
  SetColumns columns;
};
/// One set of kernels for each useful instruction set. All give the same results.
extern const PackedKernels kPackedBaseline;
#if defined(__x86_64__) || defined(__i386__)
extern const PackedKernels kPackedAvx2;
extern const PackedKernels kPackedAvx512;
#endif
/// Returns the best kernels for this processor.
[[nodiscard]] const PackedKernels &choosePackedKernels();

/// Collects one thread's small triangles of one tile. They may not be visible before finish().
class PackedShader {
public:
  PackedShader(const RasterState &state, const Shading &shading)
      : m_state(state), m_shading(shading), m_kernels(choosePackedKernels()) {}
  ~PackedShader() { finish(); }
  PackedShader(const PackedShader &) = delete;
  PackedShader &operator=(const PackedShader &) = delete;

  /// Begins a tile. Returns false if there is no packed function or no memory.
  /// \param tile the part of a tile to draw
  [[nodiscard]] bool begin(const Rect &tile);
  /// Adds a triangle. The arguments must stay valid until finish().
  /// \param blocks the triangle's blocks of 4x4 pixels in the tile
  void add(const PlanePlan &plan, const WindowVertex *window, const SmallTriangle &small,
           const abi::Block *blocks, std::uint32_t count);
  /// Adds a shape. The arguments must stay valid until finish().
  void add(const Shape &shape, const abi::Block *blocks, std::uint32_t count);
  void finish();

private:
  struct Storage;
  [[nodiscard]] static Storage *storage();
  void resolve();
  /// Returns room for one more pending triangle.
  [[nodiscard]] PackedTriangle &next();
  /// Tests the blocks of next(), whose depth is set. Keeps it as pending if some pixel passes.
  void test(PackedTriangle &next, const abi::Block *blocks, std::uint32_t count);
  /// Appends a triangle's pixels to those that wait for shading.
  void list(PackedTriangle &each, std::uint32_t owner, const abi::Block *blocks);
  /// Shades the pixels that wait.
  void shade();

  const RasterState &m_state;
  const Shading &m_shading;
  const PackedKernels &m_kernels;
  TestBlocks m_test = nullptr;
  Storage *m_storage = nullptr; ///< null: no tile has begun
  std::uint32_t m_pending = 0, m_blocks = 0;
  std::uint32_t m_owner = 0;  ///< owner number of the last triangle before the pending ones
  int m_columns = 0;          ///< number of triangles with waiting pixels
  std::uint32_t m_pixels = 0; ///< number of waiting pixels
};

} // namespace arbiter::swrast
