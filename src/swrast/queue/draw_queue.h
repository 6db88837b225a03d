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

/// Draws that are placed when they come and shaded later, many at a time.
namespace arbiter::swrast {

/// The draws of one context, in order. When a draw is added its vertices are placed, and it is set
/// up and sorted into tiles, or kept to be where it has many triangles. Tiles are shaded when
/// enough draws wait, by the other threads while the caller adds more, or when someone wants the
/// pixels (Storage::settle()). So draws of a few triangles need no thread of their own each, and
/// what the application does between them is done meanwhile.
///
/// Everything that draws read is copied but pixels, whose storages are marked (PendingUse). One
/// thread at a time adds to a queue and finishes it.
class DrawQueue final : public PendingDraws {
public:
  DrawQueue();
  ~DrawQueue();
  DrawQueue(const DrawQueue &) = delete;
  DrawQueue &operator=(const DrawQueue &) = delete;

  /// Adds what rasterize() would draw. False: it is to be drawn at once, after finish(): it fills
  /// the picture, or there is no memory.
  [[nodiscard]] bool add(const RasterState &state, const Shading &shading, Topology topology,
                         const Vertices &vertices, const std::uint32_t *indices,
                         std::uint32_t first, std::uint32_t count, const ShadingUse &use);
  void post() override;
  void finish() override;
  [[nodiscard]] bool isEmpty() const { return m_batches[0]->isEmpty() && m_batches[1]->isEmpty(); }

private:
  [[nodiscard]] bool addChecked(GivenDraw given);
  /// \param pixels that a draw of a few triangles reaches, roughly
  [[nodiscard]] bool fillsPicture(const GivenDraw &given, std::uint64_t pixels) const;
  /// What add() returns; none where the draw is no rectangle.
  [[nodiscard]] std::optional<bool> addRectangle(const GivenDraw &given);
  /// False: more than is kept.
  [[nodiscard]] bool setUpStrokes(const Draw &draw, Chunk &chunk);
  /// Joins the draw with those before it. False: there is none any more.
  [[nodiscard]] bool joinDraw(const GivenDraw &given);
  /// What is joined becomes a draw of the batch: before anything else of the batch's is touched.
  void closeJoined();
  void addJoined();
  void drawJoinedAtOnce();
  void joinRunning();
  void postFilling();
  void shadeHere(Batch &batch);
  void giveUp();
  /// Runs `work` where no other call is at the queue.
  template <typename Work> void alone(Work work);
  [[nodiscard]] Batch &filling() const { return *m_batches[m_filling]; }
  [[nodiscard]] Batch &running() const { return *m_batches[1 - m_filling]; }

  std::unique_ptr<Batch> m_batches[2]; ///< one is added to while the other is shaded
  int m_filling = 0;
  PostedJob m_job;       ///< the one that shades running()
  bool m_isOpen = false; ///< a call is at it: one of a handler that interrupted that finds it so
  /// A jump left a call: what was added is given up.
  bool m_isSpoilt = false;
  JoinedDraws m_joined; ///< with the state of the last draw of filling()
  Strokes m_strokes;
  std::vector<PlacedBounds> m_bounds;
};

} // namespace arbiter::swrast
