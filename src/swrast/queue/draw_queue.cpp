#include "swrast/queue/draw_queue.h"

#include <algorithm>
#include <new>

#include "swrast/jump_guard.h"
#include "swrast/rasterize.h"
#include "swrast/setup/place_draw.h"
#include "swrast/setup/rectangle.h"

namespace arbiter::swrast {
namespace {

/// Draws of more vertices are not queued: all threads work on each of them at once.
constexpr std::uint32_t kMaxVertices = 16384;
/// Draws of at most this many triangles may be shaded in bands, whose rows are longer than a
/// tile's.
constexpr std::uint32_t kFewTriangles = 32;
constexpr std::uint64_t kLargePixels = 32768;
/// Draws of more triangles are set up by the threads that shade them.
constexpr std::uint32_t kManyTriangles = 512;
constexpr std::size_t kMaxShapes = 4096; ///< most shapes of lines and points: 700 bytes each

/// A batch of this cost, in nanoseconds, is given to the other threads if they are free.
constexpr std::uint64_t kPostCost = 90'000;
/// A batch of less cost is shaded by one thread.
constexpr std::uint64_t kAloneCost = 40'000;
/// A batch of this cost no longer waits for the threads to be free.
constexpr std::uint64_t kMaxCost = 4'000'000;
constexpr std::size_t kMaxDraws = 2048;

std::uint64_t areaOf(const Rect &rect) {
  return std::uint64_t(rect.width) * std::uint64_t(rect.height);
}

} // namespace

DrawQueue::DrawQueue() {
  for (std::unique_ptr<Batch> &batch : m_batches)
    batch = std::make_unique<Batch>(*this);
}

DrawQueue::~DrawQueue() {
  finish();
  if (isEmpty())
    return;
  // A signal handler may end the context in the middle of a draw. Then memory that other threads
  // may read is leaked.
  awaitPosted();
  for (std::unique_ptr<Batch> &batch : m_batches)
    (void)batch.release();
}

template <typename Work> void DrawQueue::alone(Work work) {
  m_isOpen = true;
  JumpGuard guard([this] {
    m_isOpen = false;
    m_isSpoilt = true;
  });
  work();
  guard.done();
  m_isOpen = false;
}

// --- Adding ---

bool DrawQueue::add(const RasterState &state, const Shading &shading, Topology topology,
                    const Vertices &vertices, const std::uint32_t *indices, std::uint32_t first,
                    std::uint32_t count, const ShadingUse &use) {
  if (vertices.make || count > kMaxVertices || vertices.count > kMaxVertices || m_isOpen)
    return false;
  bool isAdded = false;
  alone([&] {
    try {
      isAdded = addChecked({{state, shading, topology, vertices, indices, first, count}, use});
    } catch (const std::bad_alloc &) {
      // the draw was not added
    }
    if (filling().cost() >= (isOver(m_job) ? kPostCost : kMaxCost))
      postFilling();
  });
  return isAdded;
}

/// True if a draw should be shaded at once, by rows: nothing is queued, and it fills most of the
/// picture, as a filter or a simulation step does. All threads shade it then, and rows of bands are
/// longer than rows of tiles. Other draws are queued, because shading each at once would make all
/// threads wait for it.
bool DrawQueue::fillsPicture(const GivenDraw &given, std::uint64_t pixels) const {
  return given.shading.row && pixels >= kLargePixels && 2 * pixels >= areaOf(given.state.clip) &&
         isEmpty();
}

std::optional<bool> DrawQueue::addRectangle(const GivenDraw &given) {
  Rectangle rectangle;
  if (!isPolygonal(given.topology) ||
      !findRectangle(given.state, given.topology, given.vertices, given.indices, given.first,
                     given.count, rectangle))
    return std::nullopt;
  const Rect &pixels = rectangle.pixels;
  if (pixels.empty())
    return true;
  if (fillsPicture(given, areaOf(pixels)))
    return false;
  Shape shapes[2];
  const Draw draw = drawOf(given);
  const int parts = shapesOfRectangle(draw, rectangle, shapes);
  if (parts == 0)
    return std::nullopt;
  closeJoined();
  Chunk &chunk = filling().next().begin();
  chunk.clear(TileGrid::of(pixels));
  for (int i = 0; i < parts; ++i)
    chunk.addShape(shapes[i], given.shading.inputCount,
                   given.shading.opaque && !shapes[i].stippled);
  filling().add(given.state, given.shading, given.use, given.isSameState);
  return true;
}

bool DrawQueue::addChecked(GivenDraw given) {
  given.count = drawnCount(given);
  const Sight sight = given.count != 0 ? sightOf(given) : Sight::None;
  if (sight == Sight::None)
    return true;
  if (m_isSpoilt)
    giveUp();
  given.isSameState = filling().isLast(given.state, given.shading, given.use);
  if (filling().draws() == kMaxDraws || (!given.isSameState && filling().meets(given.use))) {
    postFilling();
    given.isSameState = false;
  }
  if (const std::optional<bool> isAdded = addRectangle(given))
    return *isAdded;
  if (given.isSameState && sight == Sight::Whole && joinDraw(given))
    return true;
  closeJoined();
  Batch &batch = filling();
  QueuedDraw &queued = batch.next();
  Draw draw = drawOf(given);
  placeVertices(draw, queued.window(), m_bounds);
  Chunk &chunk = queued.begin();
  if (isPolygonal(given.topology) && draw.isFilled()) {
    if (draw.visible.empty())
      return true;
    const std::uint32_t triangles = triangleCount(given.topology, given.count);
    if (triangles > kManyTriangles && !draw.isClipped) {
      queued.keep(draw, triangles);
      batch.addKept(given.state, given.shading, given.use, given.isSameState);
      return true;
    }
    chunk.clear(TileGrid::of(draw.visible, draw.bounds));
    chunk.setUp(draw, 0, triangles);
    if (triangles <= kFewTriangles && fillsPicture(given, chunk.area()))
      return false;
  } else if (!setUpStrokes(draw, chunk)) {
    return false;
  }
  if (chunk.primitives() == 0)
    return true;
  if (chunk.readsVertices())
    queued.keepInputs(draw.plan, given.vertices.count);
  batch.add(given.state, given.shading, given.use, given.isSameState);
  return true;
}

bool DrawQueue::joinDraw(const GivenDraw &given) {
  if (m_joined.add(given))
    return true;
  closeJoined();
  return !filling().isEmpty() && m_joined.add(given);
}

void DrawQueue::closeJoined() {
  if (m_joined.isEmpty()) [[likely]]
    return;
  try {
    addJoined();
  } catch (const std::bad_alloc &) {
    drawJoinedAtOnce();
  }
  m_joined.clear();
}

void DrawQueue::addJoined() {
  Batch &batch = filling();
  QueuedDraw &queued = batch.next();
  const QueuedState &state = batch.lastState();
  Draw draw = drawOf({state.raster(), state.shading(), Topology::Triangles, m_joined.vertices(),
                      m_joined.indices(), 0, m_joined.count()});
  draw.provokingAt = JoinedDraws::kProvokingAt;
  placeVertices(draw, queued.window(), m_bounds);
  if (draw.visible.empty())
    return;
  Chunk &chunk = queued.begin();
  chunk.clear(TileGrid::of(draw.visible, draw.bounds));
  chunk.setUp(draw, 0, m_joined.count() / 3);
  if (chunk.primitives() == 0)
    return;
  if (chunk.readsVertices())
    queued.keepInputs(draw.plan, m_joined.vertices().count);
  batch.addLike();
}

/// Draws the joined draws at once, because there is no memory to queue them.
void DrawQueue::drawJoinedAtOnce() {
  joinRunning();
  const QueuedState &state = filling().lastState();
  const std::shared_ptr<const void> functions = state.functions();
  shadeHere(filling());
  (void)rasterize(state.raster(), state.shading(), Topology::Triangles, m_joined.vertices(),
                  m_joined.indices(), 0, m_joined.count(), JoinedDraws::kProvokingAt);
}

bool DrawQueue::setUpStrokes(const Draw &draw, Chunk &chunk) {
  // Lines and points reach beyond the bounds of their vertices.
  chunk.clear(TileGrid::of(draw.state.clip));
  const auto add = [](void *user, const Draw &of, const Shape *shapes, std::size_t count) {
    auto &to = *static_cast<Chunk *>(user);
    if (to.primitives() >= kMaxShapes)
      return; // too many to keep
    for (std::size_t i = 0; i < count; ++i)
      to.addShape(shapes[i], of.shading.inputCount, of.shading.opaque && !shapes[i].stippled);
  };
  m_strokes.gather(draw, {add, &chunk});
  return chunk.primitives() < kMaxShapes;
}

// --- Shading ---

namespace {
void shadeTileOf(void *batch, std::uint32_t number) {
  static_cast<Batch *>(batch)->shadeTile(number);
}
} // namespace

void DrawQueue::joinRunning() {
  if (running().isEmpty())
    return;
  join(m_job);
  running().reset();
}

void DrawQueue::shadeHere(Batch &batch) {
  if (batch.cost() >= kAloneCost)
    parallel(batch.tiles(), shadeTileOf, &batch);
  else
    for (std::uint32_t i = 0; i < batch.tiles(); ++i)
      batch.shadeTile(i);
  batch.reset();
}

void DrawQueue::postFilling() {
  closeJoined();
  joinRunning();
  Batch &batch = filling();
  if (batch.isEmpty())
    return;
  m_job =
      batch.cost() >= kAloneCost ? swrast::post(batch.tiles(), shadeTileOf, &batch) : PostedJob();
  if (m_job.number == 0)
    return shadeHere(batch);
  m_filling = 1 - m_filling;
}

void DrawQueue::giveUp() {
  m_isSpoilt = false;
  awaitPosted(); // the jump may have come before m_job was set
  joinRunning();
  filling().reset();
  m_joined.clear();
  // The batch's lists may be inconsistent.
  m_batches[m_filling] = std::make_unique<Batch>(*this);
}

void DrawQueue::post() {
  if (!m_isOpen && !filling().isEmpty() && !m_isSpoilt)
    alone([this] { postFilling(); });
}

void DrawQueue::finish() {
  if (m_isOpen || (isEmpty() && !m_isSpoilt))
    return;
  alone([this] {
    if (m_isSpoilt)
      return giveUp();
    closeJoined();
    joinRunning();
    if (!filling().isEmpty())
      shadeHere(filling());
  });
}

} // namespace arbiter::swrast
