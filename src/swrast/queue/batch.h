#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "swrast/queue/queued_draw.h"

/// A batch of draws that are shaded together, tile by tile.
namespace arbiter::swrast {

/// Draws in order, with the tiles that they reach and the storages that they read and write. First
/// draws are added, then threads shade its tiles, then it is reset.
class Batch {
public:
  explicit Batch(PendingDraws &queue) : m_queue(queue) {}
  Batch(const Batch &) = delete;
  Batch &operator=(const Batch &) = delete;

  // --- Adding draws. Functions that allocate may throw std::bad_alloc, and then add nothing. ---

  /// Returns the object for the next draw. It becomes part of the batch when one of the add
  /// functions is called.
  [[nodiscard]] QueuedDraw &next();
  /// Adds next(), which has been set up.
  /// \param isSameState the result of isLast() before; the batch may have been shaded since then
  void add(const RasterState &state, const Shading &shading, const ShadingUse &use,
           bool isSameState);
  /// Adds next(), which keeps its input to be set up later.
  void addKept(const RasterState &state, const Shading &shading, const ShadingUse &use,
               bool isSameState);
  /// Adds next(), which has been set up, with the state of the last draw.
  void addLike();
  /// Returns the state of the last draw. Requires that there is one.
  [[nodiscard]] const QueuedState &lastState() const { return *m_states[m_stateCount - 1]; }
  /// True if the last draw has the same state.
  [[nodiscard]] bool isLast(const RasterState &state, const Shading &shading,
                            const ShadingUse &use) const {
    return m_stateCount != 0 && m_states[m_stateCount - 1]->isSame(state, shading, use);
  }
  /// True if a draw reads what the batch writes, or writes what the batch reads. It may touch any
  /// pixel of the images, so it must wait.
  [[nodiscard]] bool meets(const ShadingUse &use) const;

  [[nodiscard]] bool isEmpty() const { return m_drawCount == 0; }
  [[nodiscard]] std::size_t draws() const { return m_drawCount; }
  /// Returns the approximate time to shade the batch on one thread, in nanoseconds.
  [[nodiscard]] std::uint64_t cost() const { return m_cost; }

  // --- Shading ---

  [[nodiscard]] std::uint32_t tiles() const { return std::uint32_t(m_reached.size()); }
  /// Shades tile `number` of tiles(), after all delayed set-up. Several threads may call it at the
  /// same time.
  void shadeTile(std::uint32_t number);

  // --- After shading, or to drop what was added ---

  void reset();

private:
  static constexpr std::uint32_t kNone = ~0u;
  /// A chunk of a draw in a tile; the chunk may have no primitive there.
  struct Segment {
    std::uint32_t draw, chunk, tile; ///< number in the batch; in the draw; in the chunk's grid
    std::uint32_t next;
  };
  struct Tile {
    std::uint32_t first = kNone, last = kNone;
  };
  /// A chunk that is still to be set up.
  struct SetUp {
    std::uint32_t draw, chunk;
  };

  void takeState(QueuedDraw &draw, const RasterState &state, const Shading &shading,
                 const ShadingUse &use, bool isSameState);
  void mark(const ShadingUse &use);
  template <typename IsEmpty> void sort(const TileGrid &grid, std::uint32_t chunk, IsEmpty isEmpty);
  void makeRoom(const QueuedDraw &draw);
  /// Adds a draw that has its state. Requires makeRoom().
  void addSetUp(QueuedDraw &draw);
  void setUpAll();
  void freeLargest();

  PendingDraws &m_queue;
  std::uint32_t m_number = 1; ///< identifies this batch where storages are marked
  std::vector<std::unique_ptr<QueuedState>> m_states;
  std::vector<std::unique_ptr<QueuedDraw>> m_draws;
  std::size_t m_stateCount = 0, m_drawCount = 0; ///< number in use
  std::vector<Segment> m_segments;
  std::vector<Tile> m_tiles;            ///< rows of kAcross tiles
  std::vector<std::uint32_t> m_reached; ///< indices of the tiles that have a segment
  std::vector<Storage *> m_storages;
  std::uint64_t m_cost = 0;
  std::vector<SetUp> m_setUps;
  std::atomic<std::uint32_t> m_nextSetUp{0}, m_setUpsDone{0};
};

} // namespace arbiter::swrast
