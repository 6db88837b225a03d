#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "swrast/cover/chunk.h"
#include "swrast/queue/queued_state.h"
#include "swrast/setup/place.h"
#include "swrast/strokes/strokes.h"
#include "swrast/threads.h"

/// Draws that are set up when they come and shaded later, many at a time.
namespace arbiter::swrast {

/// The draws of one context, in order. A draw is placed, set up and sorted into tiles when it is
/// added; tiles are shaded when enough of them wait, by the other threads while the caller adds
/// more, or when someone wants the pixels (Storage::settle()). So draws of a few triangles need no
/// thread of their own each, and what the application does between them is done meanwhile.
///
/// Everything that draws read is copied but pixels: whose storages are marked (PendingUse). One
/// thread at a time adds to a queue and finishes it.
class DrawQueue final : public PendingDraws {
public:
  DrawQueue();
  ~DrawQueue();
  DrawQueue(const DrawQueue &) = delete;
  DrawQueue &operator=(const DrawQueue &) = delete;

  /// Adds what rasterize() would draw. False: it is drawn at once, after finish(): it is large
  /// enough for all threads, or there is no memory.
  [[nodiscard]] bool add(const RasterState &state, const Shading &shading, Topology topology,
                         const Vertices &vertices, const std::uint32_t *indices,
                         std::uint32_t first, std::uint32_t count, const ShadingUse &use);
  void post() override;
  void finish() override;
  [[nodiscard]] bool isEmpty() const;

private:
  static constexpr std::uint32_t kNone = ~0u;

  struct QueuedDraw {
    const QueuedState *state = nullptr;
    Chunk chunk;
    std::vector<WindowVertex> window;
    std::vector<float> values; ///< of the vertices' inputs
    PlanePlan plan;            ///< over `values`
  };
  /// A draw in a tile.
  struct Segment {
    std::uint32_t draw, tile; ///< number in the batch; in the draw's grid
    std::uint32_t next;
  };
  struct Tile {
    std::uint32_t first = kNone, last = kNone;
  };
  struct Batch {
    std::uint32_t number = 0;
    std::vector<std::unique_ptr<QueuedState>> states;
    std::vector<std::unique_ptr<QueuedDraw>> draws;
    std::size_t stateCount = 0, drawCount = 0; ///< of those that wait
    std::vector<Segment> segments;
    std::vector<Tile> tiles;           ///< kAcross of each row of tiles
    std::vector<std::uint32_t> reached; ///< tiles that have a segment
    std::vector<Storage *> storages;
    std::uint64_t cost = 0; ///< of shading: nanoseconds, roughly
    PostedJob job;
    void shadeTile(std::uint32_t index) const; ///< of `reached`
  };
  enum class Added { Yes, Large };

  Added addChecked(const RasterState &state, const Shading &shading, Topology topology,
                   const Vertices &vertices, const std::uint32_t *indices, std::uint32_t first,
                   std::uint32_t count, const ShadingUse &use);
  /// False: more than is kept.
  [[nodiscard]] bool setUpStrokes(const Draw &draw, Chunk &chunk);
  /// The draw has the values of its vertices' inputs itself.
  static void keepVertices(QueuedDraw &draw, const PlanePlan &plan, std::uint32_t count);
  /// The draw, which is set up, is the batch's next one.
  void take(Batch &batch, QueuedDraw &draw, const RasterState &state, const Shading &shading,
            const ShadingUse &use);
  static void sort(Batch &batch, const Chunk &chunk);
  /// A draw reads what those that wait write, or writes what they read, at other pixels than its
  /// own maybe.
  [[nodiscard]] bool meetsItself(const ShadingUse &use) const;
  void mark(Batch &batch, const ShadingUse &use);
  void joinRunning();
  void postHere();
  void shadeHere(Batch &batch);
  void reset(Batch &batch);
  void leftHalfDone();
  [[nodiscard]] Batch &filling() { return *m_batches[m_filling]; }
  [[nodiscard]] Batch &running() { return *m_batches[1 - m_filling]; }

  std::unique_ptr<Batch> m_batches[2]; ///< one is added to while the other is shaded
  int m_filling = 0;
  std::uint32_t m_lastNumber = 0;
  bool m_isOpen = false; ///< a call is at it: one of a handler that interrupted that finds it so
  /// A jump left a call; what was added to the batch is lost.
  bool m_isSpoilt = false;
  Strokes m_strokes;
  std::vector<PlacedBounds> m_bounds;
};

} // namespace arbiter::swrast
