#pragma once
#include <atomic>
#include <cstdint>

namespace arbiter::state::software {

/// For how long what a context keeps of objects that others may change is good (neighbours.h).
class NeighbourEpoch {
public:
  /// Moves on when a neighbour becomes or ceases to be current; odd while one is. Never 0.
  [[nodiscard]] std::uint64_t epoch() const { return m_epoch.load(std::memory_order_relaxed); }
  [[nodiscard]] static bool isCrowded(std::uint64_t epoch) { return (epoch & 1) != 0; }

private:
  friend class NeighbourTable;
  std::atomic<std::uint64_t> m_epoch{2};
  bool m_current = false; ///< on some thread
};

} // namespace arbiter::state::software
