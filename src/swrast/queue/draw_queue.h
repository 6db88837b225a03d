#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "swrast/queue/batch.h"
#include "swrast/queue/joined_draws.h"
#include "swrast/setup/place.h"
#include "swrast/strokes/strokes.h"
#include "swrast/threads.h"

/// A queue of draws. Vertices are placed when a draw is added; pixels are shaded later, for many
/// draws at a time.
namespace arbiter::swrast {

/// The queued draws of one context, in order. When a draw is added, its vertices are placed, and
/// its triangles are set up and sorted into tiles. If there are many, setup is left to the threads
/// that shade. Tiles are shaded when enough draws wait, by the other threads while the caller adds
/// more. They are also shaded when someone needs the pixels (Storage::settle()). Small draws thus
/// share the cost of waking threads, and the application's own work runs in parallel.
///
/// All that draws read is copied, except pixels, whose storages are marked (PendingUse). Only one
/// thread at a time may use a queue.
class DrawQueue final : public PendingDraws {
public:
  DrawQueue();
  ~DrawQueue();
  DrawQueue(const DrawQueue &) = delete;
  DrawQueue &operator=(const DrawQueue &) = delete;

  /// Adds the draw that rasterize() would do with these arguments. Returns false if the caller must
  /// call finish() and then draw it at once: it fills the picture, or there is no memory.
  [[nodiscard]] bool add(const RasterState &state, const Shading &shading, Topology topology,
                         const Vertices &vertices, const std::uint32_t *indices,
                         std::uint32_t first, std::uint32_t count, const ShadingUse &use);
  void post() override;
  void finish() override;
  [[nodiscard]] bool isEmpty() const { return m_batches[0]->isEmpty() && m_batches[1]->isEmpty(); }

private:
  [[nodiscard]] bool addChecked(GivenDraw given);
  /// \param pixels roughly how many pixels the draw reaches
  [[nodiscard]] bool fillsPicture(const GivenDraw &given, std::uint64_t pixels) const;
  /// Tries to add the draw as a rectangle. Returns the result of add(), or nothing if it is no
  /// rectangle.
  [[nodiscard]] std::optional<bool> addRectangle(const GivenDraw &given);
  /// Sets up lines, points or unfilled polygons. Returns false if there are too many shapes to
  /// keep.
  [[nodiscard]] bool setUpStrokes(const Draw &draw, Chunk &chunk);
  /// Joins the draw with the joined draws before it. Returns false if none of the batch's draws is
  /// left to share state with.
  [[nodiscard]] bool joinDraw(const GivenDraw &given);
  /// Adds the joined draws to the batch as one draw. Call it before anything else in the batch
  /// changes.
  void closeJoined();
  void addJoined();
  void drawJoinedAtOnce();
  void joinRunning();
  void postFilling();
  void shadeHere(Batch &batch);
  void giveUp();
  /// Runs `work` with the queue marked as in use.
  template <typename Work> void alone(Work work);
  [[nodiscard]] Batch &filling() const { return *m_batches[m_filling]; }
  [[nodiscard]] Batch &running() const { return *m_batches[1 - m_filling]; }

  std::unique_ptr<Batch> m_batches[2]; ///< one is filled while the other is shaded
  int m_filling = 0;
  PostedJob m_job;       ///< the job that shades running()
  bool m_isOpen = false; ///< true during a call, so that a handler that interrupts it can tell
  /// True if a jump left a call; what was added is then dropped.
  bool m_isSpoilt = false;
  JoinedDraws m_joined; ///< have the state of the last draw in filling()
  Strokes m_strokes;
  std::vector<PlacedBounds> m_bounds;
};

} // namespace arbiter::swrast
