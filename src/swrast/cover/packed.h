#pragma once
#include <cstdint>

#include "swrast/setup/planes.h"
#include "swrast/setup/shape.h"
#include "swrast/setup/small.h"

/// Small and thin primitives by the pixel: the rasterizer tests depth itself, in a copy of the tile
/// that stays in the processor's nearest cache, and hands the machine code full vectors of what is
/// left to be seen. Where fragments replace what is there, a tile is shaded when all its triangles
/// have been tested, so that a pixel is shaded once however many triangles lie over each other, and
/// pixels of several triangles fill a vector.
namespace arbiter::swrast {

/// Blocks of 4x4 pixels of a tile of 64x64, one behind the other; lane 4 * row + column of a block.
struct PackedTile {
  static constexpr int kSide = 64, kBlocks = 256, kLanes = 16;
  alignas(64) std::int32_t depth[kBlocks][kLanes];  ///< a pixel of the depth buffer each
  alignas(64) std::uint32_t owner[kBlocks][kLanes]; ///< the triangle seen there; 0: none
  /// Window coordinates of the pixels of a column and of a row of blocks, y from where planes
  /// begin: what all triangles of the tile are tested with.
  alignas(64) float xOf[kSide / 4][kLanes], yOf[kSide / 4][kLanes];
  std::uint16_t loaded[kBlocks / 16]; ///< bit a block: what is above is filled
  Rect rect;                          ///< what of the tile there is
  int originY;                        ///< row where planes begin
  abi::Target target;                 ///< the depth buffer
  DepthTest test;
  float minimum, maximum; ///< depth is clamped to

  /// Always inline: it is compiled for several instruction sets.
  [[nodiscard, gnu::always_inline]] static inline unsigned blockAt(int x, int y) {
    return (unsigned(y) >> 2 & 15) << 4 | (unsigned(x) >> 2 & 15);
  }
  /// A block's first pixel as the word of an abi::Pixel.
  [[nodiscard, gnu::always_inline]] static inline int placeOf(const abi::Block &block) {
    return (block.y & (kSide - 1)) << 8 | (block.x & (kSide - 1));
  }
  /// \param planesFrom row where all planes begin
  void begin(const Rect &tile, const Shading &shading, int planesFrom);
  /// Fills a block from the depth buffer; no triangle is seen in it.
  void load(int x, int y);
  /// Writes depth back, if it is written at all, and forgets all.
  void end();

private:
  template <typename Visit> void eachPixel(int x, int y, Visit visit) const;
};

/// Tests blocks of a triangle; what passes is written, owned by `owner`, and listed.
/// \param out room for `count` and one more; may be `blocks`
/// \return blocks of which something is left
using TestBlocks = std::uint32_t (*)(PackedTile &tile, const abi::DepthPlane &z,
                                     std::uint32_t owner, const abi::Block *blocks,
                                     std::uint32_t count, abi::Block *out);
/// A triangle or another shape that is shaded later, with what is left of it.
struct PackedTriangle {
  const abi::Primitive *made; ///< its planes; null: they are made of the next three
  const PlanePlan *plan;
  const SmallTriangle *small;
  const WindowVertex *window; ///< of the draw
  std::uint32_t inputs;       ///< that `made` has
  std::uint32_t count;        ///< its blocks
  abi::DepthPlane depth;
};

/// The pixels of blocks, one behind the other, of a primitive in `column`: all of the masks, or if
/// `owner` is not 0 those that it still owns. Of `quads` each quad is whole, its other pixels
/// helpers. \param out room for 16 more than the blocks have
using ListPixels = std::uint32_t (*)(const PackedTile &tile, std::uint32_t owner, unsigned column,
                                     bool quads, const abi::Block *blocks, std::uint32_t count,
                                     abi::Pixel *out);
/// What `count` triangles are shaded with, the first one's in column 0.
using SetColumns = void (*)(const RasterState &state, const PackedTriangle *const *triangles,
                            int count, abi::PrimitiveColumns &columns);
struct PackedKernels {
  TestBlocks (*test)(const DepthTest &); ///< the one for a test
  ListPixels list;
  SetColumns columns;
};
/// All give the same.
extern const PackedKernels kPackedBaseline;
#if defined(__x86_64__) || defined(__i386__)
extern const PackedKernels kPackedAvx2;
extern const PackedKernels kPackedAvx512;
#endif
/// The best that this processor runs.
[[nodiscard]] const PackedKernels &choosePackedKernels();

/// One thread's small triangles of one tile. Nothing is seen of them before finish().
class PackedShader {
public:
  PackedShader(const RasterState &state, const Shading &shading)
      : m_state(state), m_shading(shading), m_kernels(choosePackedKernels()) {}
  ~PackedShader() { finish(); }
  PackedShader(const PackedShader &) = delete;
  PackedShader &operator=(const PackedShader &) = delete;

  /// \param tile what is drawn of a tile. False where there is no function, or no memory.
  [[nodiscard]] bool begin(const Rect &tile);
  /// What is named stays where it is until finish().
  /// \param blocks what of the triangle lies in the tile; of 4x4 pixels
  void add(const PlanePlan &plan, const WindowVertex *window, const SmallTriangle &small,
           const abi::Block *blocks, std::uint32_t count);
  /// The same of a shape.
  void add(const Shape &shape, const abi::Block *blocks, std::uint32_t count);
  void finish();

private:
  struct Storage;
  [[nodiscard]] static Storage *storage();
  void resolve();
  /// Room for one that waits.
  [[nodiscard]] PackedTriangle &next();
  /// Tests blocks of next(), whose depth is set, and keeps it if some of it is seen.
  void test(PackedTriangle &next, const abi::Block *blocks, std::uint32_t count);
  /// Puts a triangle's pixels behind those that wait.
  void list(PackedTriangle &each, std::uint32_t owner, const abi::Block *blocks);
  /// Shades the pixels that wait.
  void shade();

  const RasterState &m_state;
  const Shading &m_shading;
  const PackedKernels &m_kernels;
  TestBlocks m_test = nullptr;
  Storage *m_storage = nullptr; ///< null: not begun
  std::uint32_t m_pending = 0, m_blocks = 0;
  std::uint32_t m_owner = 0;  ///< of the last triangle before the pending ones
  int m_columns = 0;          ///< triangles with pixels that wait
  std::uint32_t m_pixels = 0; ///< that wait
};

} // namespace arbiter::swrast
