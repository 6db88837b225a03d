#include "swrast/packed.h"

#include <algorithm>
#include <memory>
#include <new>

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

PackedShader::Storage *PackedShader::storage() {
  thread_local std::unique_ptr<Storage> instance __attribute__((tls_model("initial-exec")));
  if (!instance)
    instance.reset(new (std::nothrow) Storage);
  return instance.get();
}

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
  m_plan = &plan;
  if (m_pending == kMostPending || m_blocks > kMostBlocks)
    resolve();
  Storage &own = *m_storage;
  abi::Plane z;
  if (own.tile.test.layout != abi::Layout::None)
    z = makeDepthPlane(m_state, triangle, m_state.offsetFill, origin.left, origin.bottom);
  abi::Block *const left = own.blocks + m_blocks;
  const std::uint32_t seen =
      m_test(own.tile, z, origin.left, origin.bottom, m_owner + m_pending + 1, blocks, count, left);
  if (seen == 0)
    return;
  if (!m_shading.replaces) {
    shade(triangle, origin.left, origin.bottom, 0, left, seen);
    return;
  }
  own.pending[m_pending++] = {triangle, origin.left, origin.bottom, seen};
  m_blocks += seen;
}

void PackedShader::shade(const Triangle &triangle, int originX, int originY, std::uint32_t owner,
                         const abi::Block *blocks, std::uint32_t count) {
  Storage &own = *m_storage;
  const std::uint32_t pixels =
      m_kernels.list(own.tile, owner, m_shading.packsQuads, blocks, count, own.pixels);
  if (pixels == 0)
    return;
  makePlanes(m_state, *m_plan, triangle, m_state.offsetFill, originX, originY, own.primitive);
  m_shading.packed(m_shading.data, &own.primitive, own.pixels, pixels);
}

void PackedShader::resolve() {
  Storage &own = *m_storage;
  const abi::Block *blocks = own.blocks;
  for (std::uint32_t i = 0; i < m_pending; ++i) {
    const Pending &each = own.pending[i];
    shade(each.triangle, each.originX, each.originY, m_owner + i + 1, blocks, each.count);
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
