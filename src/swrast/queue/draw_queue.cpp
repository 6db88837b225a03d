#include "swrast/queue/draw_queue.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <optional>

#include "swrast/jump_guard.h"
#include "swrast/setup/place_draw.h"
#include "swrast/setup/rectangle.h"

namespace arbiter::swrast {
namespace {

/// Draws of more vertices are set up and shaded by all threads as they come.
constexpr std::uint32_t kMostVertices = 16384;
/// Of draws of so few triangles a look at their area pays: larger ones are shaded in bands, whose
/// rows are longer than a tile's.
constexpr std::uint32_t kFewTriangles = 32;
constexpr std::uint64_t kLargePixels = 32768;
constexpr std::size_t kMostShapes = 4096; ///< of lines and points; of 700 bytes each

// Nanoseconds of one thread, roughly. It matters only whether waking another one pays.
constexpr std::uint64_t kDrawCost = 100, kLinkCost = 80, kPixelCost = 1;
/// A batch that costs so much is given to the other threads, if they are free.
constexpr std::uint64_t kPostCost = 60'000;
/// What is less is done by one thread.
constexpr std::uint64_t kAloneCost = 15'000;
/// A batch waits no longer for the threads to be free.
constexpr std::uint64_t kMostCost = 4'000'000;
constexpr std::size_t kMostDraws = 2048;

/// A row of tiles in Batch::tiles: 16384 pixels.
constexpr std::uint32_t kAcross = 16384 >> TileGrid::kTileShift;

/// The next of a store whose elements are used again.
template <typename T> T &nextOf(std::vector<std::unique_ptr<T>> &store, std::size_t used) {
  if (used == store.size())
    store.push_back(std::make_unique<T>());
  return *store[used];
}

bool isLarge(const Chunk &chunk, std::uint32_t triangles) {
  return triangles <= kFewTriangles && chunk.area() >= kLargePixels;
}

} // namespace

DrawQueue::DrawQueue() {
  for (std::unique_ptr<Batch> &batch : m_batches) {
    batch = std::make_unique<Batch>();
    batch->number = ++m_lastNumber;
  }
}

DrawQueue::~DrawQueue() {
  finish();
  if (isEmpty())
    return;
  // A handler ends the context in the midst of a draw. What other threads read is not freed.
  awaitPosted();
  for (std::unique_ptr<Batch> &batch : m_batches)
    (void)batch.release();
}

bool DrawQueue::isEmpty() const {
  return m_batches[0]->drawCount == 0 && m_batches[1]->drawCount == 0;
}

// --- Adding ---

bool DrawQueue::add(const RasterState &state, const Shading &shading, Topology topology,
                    const Vertices &vertices, const std::uint32_t *indices, std::uint32_t first,
                    std::uint32_t count, const ShadingUse &use) {
  if (vertices.make || count > kMostVertices || vertices.count > kMostVertices || m_isOpen)
    return false;
  m_isOpen = true;
  JumpGuard guard([this] { leftHalfDone(); });
  Added added = Added::Large;
  try {
    added = addChecked(state, shading, topology, vertices, indices, first, count, use);
  } catch (const std::bad_alloc &) {
    // What was not counted yet is not in the batch.
  }
  guard.done();
  m_isOpen = false;
  return added == Added::Yes;
}

void DrawQueue::leftHalfDone() {
  m_isOpen = false;
  m_isSpoilt = true;
}

DrawQueue::Added DrawQueue::addChecked(const RasterState &state, const Shading &shading,
                                       Topology topology, const Vertices &vertices,
                                       const std::uint32_t *indices, std::uint32_t first,
                                       std::uint32_t count, const ShadingUse &use) {
  if (state.clip.empty() || (!shading.row && !shading.quad) || count == 0)
    return Added::Yes;
  if (!indices) {
    if (first >= vertices.count)
      return Added::Yes;
    count = std::min(count, vertices.count - first);
  }
  if (m_isSpoilt || meetsItself(use) || filling().drawCount == kMostDraws)
    postHere();
  Batch &batch = filling();
  QueuedDraw &queued = nextOf(batch.draws, batch.drawCount);
  Rectangle rectangle;
  if (isPolygonal(topology) &&
      findRectangle(state, topology, vertices, indices, first, count, rectangle)) {
    const Rect &pixels = rectangle.pixels;
    if (pixels.empty())
      return Added::Yes;
    if (std::uint64_t(pixels.width) * std::uint64_t(pixels.height) >= kLargePixels)
      return Added::Large;
    Shape shape;
    if (shapeOfRectangle(state, shading, topology, vertices, rectangle, shape)) {
      queued.chunk.clear(TileGrid::of(pixels));
      queued.chunk.addShape(shape, shading.inputCount, shading.opaque && !shape.stippled);
      take(batch, queued, state, shading, use);
      return Added::Yes;
    }
  }
  Draw draw = drawOf(state, shading, topology, vertices, indices, first, count);
  placeVertices(draw, queued.window, m_bounds);
  if (isPolygonal(topology) && draw.isFilled()) {
    if (draw.visible.empty())
      return Added::Yes;
    const std::uint32_t triangles = triangleCount(topology, count);
    queued.chunk.clear(TileGrid::of(draw.visible));
    queued.chunk.setUp(draw, 0, triangles);
    if (isLarge(queued.chunk, triangles))
      return Added::Large;
  } else if (!setUpStrokes(draw, queued.chunk)) {
    return Added::Large;
  }
  if (queued.chunk.primitives() == 0)
    return Added::Yes;
  if (queued.chunk.readsVertices())
    keepVertices(queued, draw.plan, vertices.count);
  take(batch, queued, state, shading, use);
  return Added::Yes;
}

bool DrawQueue::setUpStrokes(const Draw &draw, Chunk &chunk) {
  // They are wider than what lies between their vertices.
  chunk.clear(TileGrid::of(draw.state.clip));
  const auto add = [](void *user, const Draw &of, const Shape *shapes, std::size_t shapeCount) {
    auto &to = *static_cast<Chunk *>(user);
    if (to.primitives() >= kMostShapes)
      return; // more than is kept
    for (std::size_t i = 0; i < shapeCount; ++i)
      to.addShape(shapes[i], of.shading.inputCount, of.shading.opaque && !shapes[i].stippled);
  };
  m_strokes.gather(draw, {add, &chunk});
  return chunk.primitives() < kMostShapes;
}

void DrawQueue::keepVertices(QueuedDraw &draw, const PlanePlan &plan, std::uint32_t count) {
  PlanePlan &own = draw.plan;
  own.linearFrom = plan.linearFrom;
  own.flatFrom = plan.flatFrom;
  own.count = plan.count;
  own.wantsDepth = plan.wantsDepth;
  own.wantsW = plan.wantsW;
  std::copy_n(plan.sources, plan.count, own.sources);
  std::size_t arrays = 0;
  for (int i = 0; i < plan.count; ++i)
    arrays += plan.sources[i].values[0] == plan.sources[i].values[1] ? 1 : 2;
  draw.values.resize(arrays * count);
  float *next = draw.values.data();
  for (int i = 0; i < plan.count; ++i) {
    PlanePlan::Source &source = own.sources[i];
    for (int face = 0; face < 2; ++face) {
      if (source.mask[face] == 0)
        continue; // a constant
      if (face == 1 && plan.sources[i].values[0] == plan.sources[i].values[1]) {
        source.values[1] = source.values[0];
        continue;
      }
      std::memcpy(next, source.values[face], count * sizeof *next);
      source.values[face] = next;
      next += count;
    }
  }
}

void DrawQueue::take(Batch &batch, QueuedDraw &draw, const RasterState &state,
                     const Shading &shading, const ShadingUse &use) {
  const bool isSame = batch.stateCount != 0 &&
                      batch.states[batch.stateCount - 1]->isSame(state, shading, use);
  if (!isSame) {
    nextOf(batch.states, batch.stateCount).set(state, shading, use);
    mark(batch, use);
    ++batch.stateCount;
  }
  draw.state = batch.states[batch.stateCount - 1].get();
  sort(batch, draw.chunk);
  batch.cost += kDrawCost + kLinkCost * draw.chunk.links() + kPixelCost * draw.chunk.area();
  ++batch.drawCount;
  if ((batch.cost >= kPostCost && isOver(running().job)) || batch.cost >= kMostCost)
    postHere();
}

void DrawQueue::sort(Batch &batch, const Chunk &chunk) {
  const TileGrid &grid = chunk.grid();
  const std::size_t rows = std::size_t(grid.bottom) + std::size_t(grid.rows);
  if (batch.tiles.size() < rows * kAcross)
    batch.tiles.resize(rows * kAcross);
  batch.segments.reserve(batch.segments.size() + grid.count());
  batch.reached.reserve(batch.reached.size() + grid.count());
  std::uint32_t number = 0;
  for (int y = 0; y < grid.rows; ++y)
    for (int x = 0; x < grid.columns; ++x, ++number) {
      if (chunk.isEmpty(number))
        continue;
      const auto at = std::uint32_t(grid.bottom + y) * kAcross + std::uint32_t(grid.left + x);
      Tile &tile = batch.tiles[at];
      const auto segment = std::uint32_t(batch.segments.size());
      batch.segments.push_back({std::uint32_t(batch.drawCount), number, kNone});
      if (tile.first == kNone) {
        tile.first = segment;
        batch.reached.push_back(at);
      } else {
        batch.segments[tile.last].next = segment;
      }
      tile.last = segment;
    }
}

// --- What draws use ---

bool DrawQueue::meetsItself(const ShadingUse &use) const {
  const std::uint32_t number = m_batches[m_filling]->number;
  const auto isOfBatch = [&](Storage *storage) {
    const PendingUse &pending = storage->pendingUse();
    return pending.draws == this && pending.batch == number;
  };
  return std::any_of(use.targets.begin(), use.targets.end(),
                     [&](Storage *storage) {
                       return isOfBatch(storage) && storage->pendingUse().isSampled;
                     }) ||
         std::any_of(use.textures.begin(), use.textures.end(), [&](Storage *storage) {
           return isOfBatch(storage) && storage->pendingUse().isDrawnTo;
         });
}

void DrawQueue::mark(Batch &batch, const ShadingUse &use) {
  batch.storages.reserve(batch.storages.size() + use.targets.size() + use.textures.size());
  const auto markOne = [&](Storage *storage) -> PendingUse & {
    PendingUse &pending = storage->pendingUse();
    if (pending.draws && pending.draws != this)
      pending.draws->finish();
    if (pending.draws != this || pending.batch != batch.number) {
      pending = {this, batch.number, false, false};
      batch.storages.push_back(storage);
    }
    return pending;
  };
  for (Storage *const storage : use.targets)
    markOne(storage).isDrawnTo = true;
  for (Storage *const storage : use.textures)
    markOne(storage).isSampled = true;
}

// --- Shading ---

void DrawQueue::Batch::shadeTile(std::uint32_t index) const {
  const std::uint32_t at = reached[index];
  const auto x = std::int32_t(at % kAcross), y = std::int32_t(at / kAcross);
  constexpr int kTile = TileGrid::kTile, kShift = TileGrid::kTileShift;
  const QueuedState *state = nullptr;
  std::optional<Emitter> emitter;
  Rect rect;
  for (std::uint32_t each = tiles[at].first; each != kNone; each = segments[each].next) {
    const QueuedDraw &draw = *draws[segments[each].draw];
    if (draw.state != state) {
      emitter.reset();
      state = draw.state;
      rect = intersect(state->raster().clip, {x << kShift, y << kShift, kTile, kTile});
      emitter.emplace(state->raster(), state->shading());
      emitter->beginTile(rect);
    }
    draw.chunk.shade(segments[each].tile, draw.plan, draw.window.data(), rect, *emitter);
  }
}

namespace {
template <typename Batch> void shadeTileOf(void *batch, std::uint32_t number) {
  static_cast<const Batch *>(batch)->shadeTile(number);
}
} // namespace

void DrawQueue::joinRunning() {
  if (running().drawCount == 0)
    return;
  join(running().job);
  reset(running());
}

void DrawQueue::shadeHere(Batch &batch) {
  const auto count = std::uint32_t(batch.reached.size());
  if (batch.cost >= kAloneCost)
    parallel(count, shadeTileOf<Batch>, &batch);
  else
    for (std::uint32_t i = 0; i < count; ++i)
      batch.shadeTile(i);
  reset(batch);
}

void DrawQueue::reset(Batch &batch) {
  for (const std::uint32_t tile : batch.reached)
    batch.tiles[tile] = {};
  batch.reached.clear();
  batch.segments.clear();
  for (std::size_t i = 0; i < batch.stateCount; ++i)
    batch.states[i]->release();
  batch.stateCount = batch.drawCount = 0;
  batch.cost = 0;
  batch.job = {};
  for (Storage *const storage : batch.storages)
    if (PendingUse &pending = storage->pendingUse();
        pending.draws == this && pending.batch == batch.number)
      pending = {};
  batch.storages.clear();
  batch.number = ++m_lastNumber;
}

void DrawQueue::postHere() {
  joinRunning();
  Batch &batch = filling();
  if (m_isSpoilt) { // its lists may be half made
    m_isSpoilt = false;
    awaitPosted(); // it may be the others' already
    std::fill(batch.tiles.begin(), batch.tiles.end(), Tile());
    return reset(batch);
  }
  if (batch.drawCount == 0)
    return;
  if (batch.cost >= kAloneCost)
    batch.job = swrast::post(std::uint32_t(batch.reached.size()), shadeTileOf<Batch>, &batch);
  if (batch.job.number == 0)
    return shadeHere(batch);
  m_filling = 1 - m_filling;
}

void DrawQueue::post() {
  if (m_isOpen || filling().drawCount == 0)
    return;
  m_isOpen = true;
  JumpGuard guard([this] { leftHalfDone(); });
  postHere();
  guard.done();
  m_isOpen = false;
}

void DrawQueue::finish() {
  if (m_isOpen || (isEmpty() && !m_isSpoilt))
    return;
  m_isOpen = true;
  JumpGuard guard([this] { leftHalfDone(); });
  joinRunning();
  if (m_isSpoilt)
    postHere();
  else if (filling().drawCount != 0)
    shadeHere(filling());
  guard.done();
  m_isOpen = false;
}

} // namespace arbiter::swrast
