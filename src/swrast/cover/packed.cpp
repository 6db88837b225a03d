#include "swrast/cover/packed.h"

#include <algorithm>

#include "util/per_thread.h"

namespace arbiter::swrast {

namespace {
constexpr std::uint32_t kMaxPending = 512, kMaxBlocks = 4096;
/// The pixels of one triangle at most; kVector more are written but not kept.
constexpr std::uint32_t kMaxPixels = PackedTile::kSide * PackedTile::kSide;
constexpr std::uint32_t kVector = 16;
} // namespace

struct PackedShader::Storage {
  PackedTile tile;
  alignas(64) abi::Pixel pixels[kMaxPixels + kVector];
  abi::PrimitiveColumns columns;
  const PackedTriangle *column[abi::PrimitiveColumns::kColumns];
  PackedTriangle pending[kMaxPending];
  /// A triangle has at most a tile's blocks, and one more block is written but not kept.
  abi::Block blocks[kMaxBlocks + PackedTile::kBlocks + 1];
};

PackedShader::Storage *PackedShader::storage() { return PerThread<Storage, PackedShader>::get(); }

bool PackedShader::begin(const Rect &tile) {
  m_storage = m_shading.packed ? storage() : nullptr;
  if (!m_storage)
    return false;
  constexpr int kSide = PackedTile::kSide;
  // Takes the tile's whole visible part, so that few blocks are cut.
  m_storage->tile.begin(intersect(m_state.clip, {tile.x & -kSide, tile.y & -kSide, kSide, kSide}),
                        m_shading, planesBegin(m_state));
  m_test = m_kernels.test(m_shading.depth);
  m_storage->columns.baseX = tile.x & -kSide;
  m_storage->columns.baseY = tile.y & -kSide;
  m_owner = 0;
  return true;
}

PackedTriangle &PackedShader::next() {
  if (m_pending == kMaxPending || m_blocks > kMaxBlocks)
    resolve();
  return m_storage->pending[m_pending];
}

void PackedShader::add(const PlanePlan &plan, const WindowVertex *window,
                       const SmallTriangle &small, const abi::Block *blocks, std::uint32_t count) {
  PackedTriangle &own = next();
  own.depth = small.depthPlane();
  own.made = nullptr;
  own.plan = &plan;
  own.small = &small;
  own.window = window;
  test(own, blocks, count);
}

void PackedShader::add(const Shape &shape, const abi::Block *blocks, std::uint32_t count) {
  PackedTriangle &own = next();
  own.depth = shape.primitive.z;
  own.made = &shape.primitive;
  own.inputs = m_shading.inputCount;
  test(own, blocks, count);
}

void PackedShader::test(PackedTriangle &next, const abi::Block *blocks, std::uint32_t count) {
  Storage &own = *m_storage;
  abi::Block *const left = own.blocks + m_blocks;
  next.count = m_test(own.tile, next.depth, m_owner + m_pending + 1, blocks, count, left);
  if (next.count == 0)
    return;
  if (!m_shading.replaces) {
    list(next, 0, left);
    shade();
    return;
  }
  ++m_pending;
  m_blocks += next.count;
}

void PackedShader::list(PackedTriangle &each, std::uint32_t owner, const abi::Block *blocks) {
  Storage &own = *m_storage;
  if (m_columns == m_shading.lanes || m_pixels + each.count * PackedTile::kLanes > kMaxPixels)
    shade();
  const std::uint32_t pixels =
      m_kernels.list(own.tile, owner, unsigned(m_columns), m_shading.packsQuads, blocks, each.count,
                     own.pixels + m_pixels);
  if (pixels == 0)
    return;
  own.column[m_columns++] = &each;
  m_pixels += pixels;
}

void PackedShader::shade() {
  if (m_pixels == 0)
    return;
  Storage &own = *m_storage;
  m_kernels.columns(m_state, own.column, m_columns, own.columns);
  const auto lanes = std::uint32_t(m_shading.lanes);
  abi::Pixel padding = own.pixels[m_pixels - 1];
  padding.isHelper = abi::Pixel::kHelper;
  for (; m_pixels % lanes != 0; ++m_pixels)
    own.pixels[m_pixels] = padding;
  m_shading.packed(m_shading.data, &own.columns, own.pixels, m_pixels);
  m_columns = 0;
  m_pixels = 0;
}

void PackedShader::resolve() {
  const abi::Block *blocks = m_storage->blocks;
  for (std::uint32_t i = 0; i < m_pending; ++i) {
    PackedTriangle &each = m_storage->pending[i];
    list(each, m_owner + i + 1, blocks);
    blocks += each.count;
  }
  shade();
  m_owner += m_pending;
  m_pending = m_blocks = 0;
}

void PackedShader::finish() {
  if (!m_storage)
    return;
  resolve();
  m_storage->tile.end();
  m_owner = 0;
}

} // namespace arbiter::swrast
