#include "swrast/cover/packed.h"

#include <algorithm>

#include "util/per_thread.h"

namespace arbiter::swrast {

namespace {
constexpr std::uint32_t kMostPending = 512, kMostBlocks = 4096;
/// Padding is written a vector at a time.
constexpr std::uint32_t kMostPixels = PackedTile::kSide * PackedTile::kSide + 32;
} // namespace

struct PackedShader::Storage {
  PackedTile tile;
  alignas(64) abi::Pixel pixels[kMostPixels];
  abi::Primitive primitive;
  Pending pending[kMostPending];
  /// Of a triangle there are no more than the tile has, and one is written in vain.
  abi::Block blocks[kMostBlocks + PackedTile::kBlocks + 1];
};

PackedShader::Storage *PackedShader::storage() { return PerThread<Storage, PackedShader>::get(); }

bool PackedShader::begin(const Rect &tile) {
  m_storage = m_shading.packed ? storage() : nullptr;
  if (!m_storage)
    return false;
  constexpr int kSide = PackedTile::kSide;
  // All of the tile that there is, so that few blocks are cut.
  m_storage->tile.begin(intersect(m_state.clip, {tile.x & -kSide, tile.y & -kSide, kSide, kSide}),
                        m_shading);
  m_test = m_kernels.test(m_shading.depth);
  m_owner = 0;
  return true;
}

void PackedShader::add(const PlanePlan &plan, const Triangle &triangle, const Bounds &origin,
                       const abi::Block *blocks, std::uint32_t count) {
  if (m_pending == kMostPending || m_blocks > kMostBlocks)
    resolve();
  Storage &own = *m_storage;
  Pending &next = own.pending[m_pending];
  next.gradients = gradientsOf(m_state, triangle.corner, origin.originX, origin.originY);
  next.depth = makeDepthPlane(m_state, triangle, next.gradients, m_state.offsetFill);
  abi::Block *const left = own.blocks + m_blocks;
  const std::uint32_t seen = m_test(own.tile, next.depth, origin.originX, origin.originY,
                                    m_owner + m_pending + 1, blocks, count, left);
  if (seen == 0)
    return;
  next.plan = &plan;
  next.triangle = triangle;
  next.originX = origin.originX;
  next.originY = origin.originY;
  next.count = seen;
  if (!m_shading.replaces) {
    shade(next, 0, left);
    return;
  }
  ++m_pending;
  m_blocks += seen;
}

void PackedShader::shade(const Pending &each, std::uint32_t owner, const abi::Block *blocks) {
  Storage &own = *m_storage;
  const std::uint32_t pixels =
      m_kernels.list(own.tile, owner, m_shading.packsQuads, blocks, each.count, own.pixels);
  if (pixels == 0)
    return;
  makePlanes(*each.plan, each.triangle, each.gradients, each.depth, each.originX, each.originY,
             own.primitive);
  m_shading.packed(m_shading.data, &own.primitive, own.pixels, pixels);
}

void PackedShader::resolve() {
  const abi::Block *blocks = m_storage->blocks;
  for (std::uint32_t i = 0; i < m_pending; ++i) {
    const Pending &each = m_storage->pending[i];
    shade(each, m_owner + i + 1, blocks);
    blocks += each.count;
  }
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
