#pragma once
#include <atomic>
#include <cstdint>

namespace arbiter::state {

/// Generation counter: what a context keeps of shared objects is valid while it stays the same
/// (neighbours.h).
class NeighbourEpoch {
public:
  /// Returns the counter. It advances when a neighbour becomes current or stops being current, and
  /// is odd while one is current. Never 0.
  [[nodiscard]] std::uint64_t epoch() const { return m_epoch.load(std::memory_order_relaxed); }
  [[nodiscard]] static bool isCrowded(std::uint64_t epoch) { return (epoch & 1) != 0; }

private:
  friend class NeighbourTable;
  std::atomic<std::uint64_t> m_epoch{2};
  bool m_current = false; ///< current on some thread
};

} // namespace arbiter::state
