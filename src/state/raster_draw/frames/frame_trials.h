#pragma once
#include <algorithm>

namespace arbiter::state {

/// Decides when to try a whole frame, in which the rasterizer tests depth from the beginning. What
/// the rasterizer lacks is known from state in mixed frames too, but failures of memory or machine
/// code show only when a draw is tried. If such a draw came in every frame, the rasterizer would
/// begin, and the host end, every second frame. Therefore each failed trial doubles the number of
/// frames without host draws that the next trial needs.
class FrameTrials {
public:
  /// Handles the end of a frame.
  /// \param whole true if the host drew nothing that the rasterizer cannot
  /// \param tried true if the rasterizer tested depth in it
  /// \return true if the next frame is to be tried
  bool frameEnded(bool whole, bool tried) {
    if (!whole) {
      m_needed = tried ? std::min(2 * m_needed, kMaxNeeded) : m_needed;
      m_row = m_kept = 0;
      return false;
    }
    m_row = std::min(m_row + 1, kMaxNeeded);
    m_kept = std::min(m_kept + int(tried), kKept);
    if (m_kept == kKept)
      m_needed = 1;
    return m_row >= m_needed;
  }

private:
  static constexpr int kMaxNeeded = 64;
  static constexpr int kKept = 4; ///< successful trials in a row after which failures are forgotten
  int m_needed = 1;               ///< frames in a row that a trial needs
  int m_row = 0;                  ///< such frames so far
  int m_kept = 0;                 ///< number of those that were trials
};

} // namespace arbiter::state
