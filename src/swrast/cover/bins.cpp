#include "swrast/cover/bins.h"

#include <algorithm>
#include <atomic>
#include <new>

#include "swrast/threads.h"

namespace arbiter::swrast {

void Bins::shadeTile(const Draw &draw, const TileGrid &grid, std::uint32_t tile,
                     std::uint64_t &pixels) const {
  std::uint32_t start = m_used;
  bool empty = true;
  while (start > 0) {
    if (!m_parts[--start].usable)
      continue;
    const Chunk &chunk = m_parts[start].chunk;
    empty = empty && chunk.isEmpty(tile);
    if (chunk.hidesOlder(tile))
      break;
  }
  if (empty)
    return;
  const Rect rect =
      grid.rect(grid.left + int(tile) % grid.columns, grid.bottom + int(tile) / grid.columns);
  Emitter emitter(draw.state, draw.shading);
  emitter.beginTile(rect);
  for (std::uint32_t i = start; i < m_used; ++i)
    if (m_parts[i].usable)
      m_parts[i].chunk.shade(tile, draw.plan, draw.window, rect, emitter);
  pixels += emitter.pixels();
}

void Bins::shade(const Draw &draw, std::uint32_t first, std::uint32_t count,
                 DrawStatistics &statistics) {
  if (draw.visible.empty())
    return;
  const TileGrid grid = TileGrid::of(draw.visible, draw.bounds);
  m_used = (count + Chunk::kTriangles - 1) / Chunk::kTriangles;
  if (m_parts.size() < m_used)
    m_parts.resize(m_used);
  auto setUpPart = [&](std::uint32_t i) {
    Part &part = m_parts[i];
    part.usable = false;
    try {
      part.chunk.clear(grid);
      part.chunk.setUp(draw, first + i * Chunk::kTriangles,
                       first + std::min(count, (i + 1) * Chunk::kTriangles));
      part.usable = true;
    } catch (const std::bad_alloc &) {
      // No exception may leave a worker thread. The part is skipped, and the draw is incomplete.
    }
  };
  parallel(m_used, setUpPart);
  std::atomic<std::uint64_t> pixels{0};
  auto tile = [&](std::uint32_t i) {
    std::uint64_t own = 0;
    shadeTile(draw, grid, i, own);
    if (own)
      pixels.fetch_add(own, std::memory_order_relaxed);
  };
  parallel(std::uint32_t(grid.count()), tile);
  statistics.pixels += pixels.load(std::memory_order_relaxed);
  for (std::uint32_t i = 0; i < m_used; ++i) {
    statistics.primitives += m_parts[i].usable ? m_parts[i].chunk.primitives() : 0;
    statistics.incomplete = statistics.incomplete || !m_parts[i].usable;
  }
}

} // namespace arbiter::swrast
