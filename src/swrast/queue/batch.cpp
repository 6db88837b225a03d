#include "swrast/queue/batch.h"

#include <algorithm>
#include <new>
#include <optional>
#include <sched.h>

#include "swrast/jump_guard.h"

namespace arbiter::swrast {
namespace {

// Approximate nanoseconds on one thread. They only decide whether waking another thread pays.
constexpr std::uint64_t kDrawCost = 100, kLinkCost = 80, kTriangleCost = 120;

/// The width of a row of tiles in Batch::m_tiles: 16384 pixels.
constexpr std::uint32_t kAcross = 16384 >> TileGrid::kTileShift;

/// Returns the next element of a store whose elements are reused.
template <typename T> T &nextOf(std::vector<std::unique_ptr<T>> &store, std::size_t used) {
  if (used == store.size())
    store.push_back(std::make_unique<T>());
  return *store[used];
}

/// Reserves room for `more` elements, so that the next push_back() calls cannot throw.
template <typename T> void reserve(std::vector<T> &store, std::size_t more) {
  if (store.capacity() < store.size() + more)
    store.reserve(std::max(2 * store.capacity(), store.size() + more));
}

/// Draws keep their memory for the next batch, but only this many large ones may.
constexpr std::size_t kLargeBytes = std::size_t(1) << 20, kMaxLarge = 16;

std::atomic<std::uint32_t> g_lastNumber{0};

} // namespace

// --- Adding ---

QueuedDraw &Batch::next() { return nextOf(m_draws, m_drawCount); }

void Batch::makeRoom(const QueuedDraw &draw) {
  const TileGrid &grid = draw.chunk(0).grid();
  const std::size_t rows = std::size_t(grid.bottom) + std::size_t(grid.rows);
  if (m_tiles.size() < rows * kAcross)
    m_tiles.resize(rows * kAcross);
  reserve(m_segments, grid.count() * draw.chunkCount());
  reserve(m_reached, grid.count());
  reserve(m_setUps, draw.chunkCount());
}

template <typename IsEmpty>
void Batch::sort(const TileGrid &grid, std::uint32_t chunk, IsEmpty isEmpty) {
  std::uint32_t number = 0;
  for (int y = 0; y < grid.rows; ++y)
    for (int x = 0; x < grid.columns; ++x, ++number) {
      if (isEmpty(number))
        continue;
      const auto at = std::uint32_t(grid.bottom + y) * kAcross + std::uint32_t(grid.left + x);
      Tile &tile = m_tiles[at];
      const auto segment = std::uint32_t(m_segments.size());
      m_segments.push_back({std::uint32_t(m_drawCount), chunk, number, kNone});
      if (tile.first == kNone) {
        tile.first = segment;
        m_reached.push_back(at);
      } else {
        m_segments[tile.last].next = segment;
      }
      tile.last = segment;
    }
}

void Batch::add(const RasterState &state, const Shading &shading, const ShadingUse &use,
                bool isSameState) {
  QueuedDraw &draw = *m_draws[m_drawCount];
  makeRoom(draw);
  takeState(draw, state, shading, use, isSameState);
  addSetUp(draw);
}

void Batch::addLike() {
  QueuedDraw &draw = *m_draws[m_drawCount];
  makeRoom(draw);
  draw.setState(lastState());
  addSetUp(draw);
}

void Batch::addSetUp(QueuedDraw &draw) {
  const Chunk &chunk = draw.chunk(0);
  sort(chunk.grid(), 0, [&](std::uint32_t tile) { return chunk.isEmpty(tile); });
  m_cost +=
      kDrawCost + kLinkCost * chunk.links() + draw.state()->shading().pixelCost * chunk.area();
  ++m_drawCount;
}

void Batch::addKept(const RasterState &state, const Shading &shading, const ShadingUse &use,
                    bool isSameState) {
  QueuedDraw &draw = *m_draws[m_drawCount];
  makeRoom(draw);
  takeState(draw, state, shading, use, isSameState);
  for (std::uint32_t chunk = 0; chunk < draw.chunkCount(); ++chunk) {
    sort(draw.chunk(0).grid(), chunk, [](std::uint32_t) { return false; });
    m_setUps.push_back({std::uint32_t(m_drawCount), chunk});
  }
  m_cost += kDrawCost + kTriangleCost * QueuedDraw::kChunkTriangles * draw.chunkCount();
  ++m_drawCount;
}

void Batch::takeState(QueuedDraw &draw, const RasterState &state, const Shading &shading,
                      const ShadingUse &use, bool isSameState) {
  if (!isSameState || m_stateCount == 0) {
    nextOf(m_states, m_stateCount).set(state, shading, use);
    mark(use);
    ++m_stateCount;
  }
  draw.setState(*m_states[m_stateCount - 1]);
}

// --- What draws use ---

bool Batch::meets(const ShadingUse &use) const {
  const auto isOurs = [this](const PendingUse &pending) {
    return pending.draws == &m_queue && pending.batch == m_number;
  };
  return std::any_of(use.targets.begin(), use.targets.end(),
                     [&](Storage *storage) {
                       return isOurs(storage->pendingUse()) && storage->pendingUse().isSampled;
                     }) ||
         std::any_of(use.textures.begin(), use.textures.end(), [&](Storage *storage) {
           return isOurs(storage->pendingUse()) && storage->pendingUse().isDrawnTo;
         });
}

void Batch::mark(const ShadingUse &use) {
  if (m_drawCount == 0)
    m_number = g_lastNumber.fetch_add(1, std::memory_order_relaxed) + 1;
  reserve(m_storages, use.targets.size() + use.textures.size());
  const auto markOne = [&](Storage *storage) -> PendingUse & {
    PendingUse &pending = storage->pendingUse();
    if (pending.draws && pending.draws != &m_queue)
      pending.draws->finish();
    if (pending.draws != &m_queue || pending.batch != m_number) {
      pending = {&m_queue, m_number, false, false};
      m_storages.push_back(storage);
    }
    return pending;
  };
  for (Storage *const storage : use.targets)
    markOne(storage).isDrawnTo = true;
  for (Storage *const storage : use.textures)
    markOne(storage).isSampled = true;
}

// --- Shading ---

void Batch::setUpAll() {
  const auto count = std::uint32_t(m_setUps.size());
  for (;;) {
    const std::uint32_t i = m_nextSetUp.fetch_add(1, std::memory_order_relaxed);
    if (i >= count)
      break;
    // A jump may leave a set-up half done. It is still counted, because the other threads wait for
    // it.
    const auto done = [this] { m_setUpsDone.fetch_add(1, std::memory_order_release); };
    JumpGuard guard(done);
    try {
      m_draws[m_setUps[i].draw]->setUp(m_setUps[i].chunk);
    } catch (const std::bad_alloc &) {
      // No exception may leave a worker thread. What memory was found for is drawn.
    }
    guard.done();
    done();
  }
  while (m_setUpsDone.load(std::memory_order_acquire) < count)
    sched_yield();
}

void Batch::shadeTile(std::uint32_t number) {
  if (m_setUpsDone.load(std::memory_order_acquire) < m_setUps.size())
    setUpAll();
  const std::uint32_t at = m_reached[number];
  const auto x = std::int32_t(at % kAcross), y = std::int32_t(at / kAcross);
  constexpr int kTile = TileGrid::kTile, kShift = TileGrid::kTileShift;
  const QueuedState *state = nullptr;
  std::optional<Emitter> emitter;
  Rect rect;
  for (std::uint32_t each = m_tiles[at].first; each != kNone; each = m_segments[each].next) {
    const Segment &segment = m_segments[each];
    const QueuedDraw &draw = *m_draws[segment.draw];
    if (draw.chunk(segment.chunk).isEmpty(segment.tile))
      continue;
    if (draw.state() != state) {
      emitter.reset();
      state = draw.state();
      rect = intersect(state->raster().clip, {x << kShift, y << kShift, kTile, kTile});
      emitter.emplace(state->raster(), state->shading());
      emitter->beginTile(rect);
    }
    // Planes are exact within the pixels that the draw may reach, so the tile is clipped to those,
    // as in Bins.
    draw.shade(segment.chunk, segment.tile, intersect(rect, draw.chunk(segment.chunk).grid().clip),
               *emitter);
  }
}

void Batch::freeLargest() {
  std::size_t large = 0;
  for (std::size_t i = 0; i < m_drawCount; ++i)
    if (m_draws[i]->bytes() >= kLargeBytes && ++large > kMaxLarge)
      m_draws[i]->free();
}

void Batch::reset() {
  for (const std::uint32_t tile : m_reached)
    m_tiles[tile] = {};
  m_reached.clear();
  m_segments.clear();
  m_setUps.clear();
  m_nextSetUp.store(0, std::memory_order_relaxed);
  m_setUpsDone.store(0, std::memory_order_relaxed);
  for (std::size_t i = 0; i < m_stateCount; ++i)
    m_states[i]->release();
  freeLargest();
  m_stateCount = m_drawCount = 0;
  m_cost = 0;
  for (Storage *const storage : m_storages)
    if (PendingUse &pending = storage->pendingUse();
        pending.draws == &m_queue && pending.batch == m_number)
      pending = {};
  m_storages.clear();
}

} // namespace arbiter::swrast
