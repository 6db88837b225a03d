#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "swrast/queue/queued_draw.h"

/// Draws that are shaded together, a tile at a time.
namespace arbiter::swrast {

/// Draws in order, the tiles that they reach, and the storages that they read and write. First it
/// is added to; then threads shade its tiles; then it is reset.
class Batch {
public:
  explicit Batch(PendingDraws &queue) : m_queue(queue) {}
  Batch(const Batch &) = delete;
  Batch &operator=(const Batch &) = delete;

  // --- While it is added to. What allocates throws std::bad_alloc, and then nothing was added. ---

  /// The next draw, of which the batch knows nothing before one of the two that follow.
  [[nodiscard]] QueuedDraw &next();
  /// Adds next(), which is set up. \param isSameState what isLast() said; the batch may have been
  /// shaded since
  void add(const RasterState &state, const Shading &shading, const ShadingUse &use,
           bool isSameState);
  /// Adds next(), which was kept to be set up later.
  void addKept(const RasterState &state, const Shading &shading, const ShadingUse &use,
               bool isSameState);
  /// Adds next(), which is set up and drawn with what the last draw is.
  void addLike();
  /// What the last draw is drawn with. Requires: there is one.
  [[nodiscard]] const QueuedState &lastState() const { return *m_states[m_stateCount - 1]; }
  /// The last draw is drawn with the same.
  [[nodiscard]] bool isLast(const RasterState &state, const Shading &shading,
                            const ShadingUse &use) const {
    return m_stateCount != 0 && m_states[m_stateCount - 1]->isSame(state, shading, use);
  }
  /// A draw reads what the batch's draws write, or writes what they read: at other pixels than its
  /// own, maybe.
  [[nodiscard]] bool meets(const ShadingUse &use) const;

  [[nodiscard]] bool isEmpty() const { return m_drawCount == 0; }
  [[nodiscard]] std::size_t draws() const { return m_drawCount; }
  /// Of shading it on one thread: nanoseconds, roughly.
  [[nodiscard]] std::uint64_t cost() const { return m_cost; }

  // --- While it is shaded ---

  [[nodiscard]] std::uint32_t tiles() const { return std::uint32_t(m_reached.size()); }
  /// Shades tile `number` of tiles(), and sets up before what is not: threads call it at a time.
  void shadeTile(std::uint32_t number);

  // --- After that, or where what was added is given up ---

  void reset();

private:
  static constexpr std::uint32_t kNone = ~0u;
  /// A chunk of a draw in a tile, which it may leave empty.
  struct Segment {
    std::uint32_t draw, chunk, tile; ///< number in the batch; in the draw; in the chunk's grid
    std::uint32_t next;
  };
  struct Tile {
    std::uint32_t first = kNone, last = kNone;
  };
  /// A chunk that is not set up yet.
  struct SetUp {
    std::uint32_t draw, chunk;
  };

  void takeState(QueuedDraw &draw, const RasterState &state, const Shading &shading,
                 const ShadingUse &use, bool isSameState);
  void mark(const ShadingUse &use);
  template <typename IsEmpty> void sort(const TileGrid &grid, std::uint32_t chunk, IsEmpty isEmpty);
  void makeRoom(const QueuedDraw &draw);
  /// The draw has its state, and there is room.
  void addSetUp(QueuedDraw &draw);
  void setUpAll();
  void freeLargest();

  PendingDraws &m_queue;
  std::uint32_t m_number = 1; ///< known by it where storages are marked
  std::vector<std::unique_ptr<QueuedState>> m_states;
  std::vector<std::unique_ptr<QueuedDraw>> m_draws;
  std::size_t m_stateCount = 0, m_drawCount = 0; ///< of those that wait
  std::vector<Segment> m_segments;
  std::vector<Tile> m_tiles;            ///< kAcross a row of tiles
  std::vector<std::uint32_t> m_reached; ///< the tiles that have a segment
  std::vector<Storage *> m_storages;
  std::uint64_t m_cost = 0;
  std::vector<SetUp> m_setUps;
  std::atomic<std::uint32_t> m_nextSetUp{0}, m_setUpsDone{0};
};

} // namespace arbiter::swrast
