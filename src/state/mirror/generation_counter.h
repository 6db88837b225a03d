#pragma once
#include <array>
#include <bit>
#include <cstdint>

#include "state/mirror/dirty_bits.h"

namespace arbiter::state {

/// Turns ContextHot::dirty into generations. It alone clears the dirty bits, except for the groups
/// that residency reads. Each reader remembers the time up to which it has seen all changes.
class GenerationCounter {
public:
  /// Bits that stay set, as residency clears them.
  static constexpr std::uint32_t kNotOurs = dirty::kFramebuffer | dirty::kPixelStore;
  /// The matrix that matrix commands change, as the host reported it. It is Unknown once a command
  /// may have chosen another.
  enum class CurrentMatrix : std::uint8_t { Unknown, Modelview, Other };

  /// Takes the dirty bits. Called before anything is read; costs one test if nothing changed.
  /// \param dirty ContextHot::dirty
  void take(std::uint32_t &dirty) {
    const std::uint32_t bits = dirty & ~kNotOurs;
    if (bits == 0) [[likely]]
      return;
    dirty &= kNotOurs;
    mark(bits | matrixGroups(bits));
  }
  [[nodiscard]] CurrentMatrix currentMatrix() const { return m_matrix; }
  /// Sets what the host answered. No mode change may have been marked since the query.
  void setCurrentMatrix(CurrentMatrix matrix) { m_matrix = matrix; }
  /// Marks groups as changed; also called for groups that the layer itself has changed.
  void mark(std::uint32_t bits) {
    ++m_now;
    m_latest = bits & kGroups;
    for (std::uint32_t left = bits & kGroups; left != 0; left &= left - 1)
      m_changed[std::size_t(std::countr_zero(left))] = m_now;
  }
  [[nodiscard]] std::uint64_t now() const { return m_now; }
  /// Returns the groups that changed after `seen`, a time from now(). Returns all for 0.
  [[nodiscard]] std::uint32_t changedSince(std::uint64_t seen) const {
    if (seen == m_now) [[likely]]
      return 0;
    if (seen + 1 == m_now) // the common case: a reader that looks at every draw
      return m_latest;
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < m_changed.size(); ++i)
      bits |= std::uint32_t(m_changed[i] > seen) << i;
    return bits;
  }

private:
  static constexpr std::uint32_t kGroups = (1u << dirty::kGroups) - 1;
  /// Returns the group that a change of the current matrix counts as.
  std::uint32_t matrixGroups(std::uint32_t bits) {
    if ((bits & dirty::kMatrixMode) != 0)
      m_matrix = CurrentMatrix::Unknown;
    if ((bits & dirty::kMatrix) == 0)
      return 0;
    return m_matrix == CurrentMatrix::Modelview ? dirty::kModelview : dirty::kTransform;
  }
  std::uint64_t m_now = 1;
  std::uint32_t m_latest = kGroups; ///< the groups of the last mark()
  CurrentMatrix m_matrix = CurrentMatrix::Unknown;
  std::array<std::uint64_t, dirty::kGroups> m_changed = [] {
    std::array<std::uint64_t, dirty::kGroups> times;
    times.fill(1);
    return times;
  }();
};

} // namespace arbiter::state
