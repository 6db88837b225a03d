#pragma once
#include <algorithm>

namespace arbiter::state::software {

/// When a frame is tried as a whole one: the rasterizer tests depths from its beginning. What state
/// says that the rasterizer lacks is seen in mixed frames too, but not what memory or machine code
/// come to. An application with a draw of that kind in every frame would have each second frame
/// begun by the rasterizer and ended by the host. So each trial that fails doubles the frames
/// without a turn of the host that the next one waits for.
class FrameTrials {
public:
  /// \param whole the frame had no turn of the host
  /// \param tried the rasterizer tested depths in it
  /// \return whether the next one is to be tried
  bool frameEnded(bool whole, bool tried) {
    if (!whole) {
      m_needed = tried ? std::min(2 * m_needed, kMostNeeded) : m_needed;
      m_row = m_kept = 0;
      return false;
    }
    m_row = std::min(m_row + 1, kMostNeeded);
    m_kept = std::min(m_kept + int(tried), kKept);
    if (m_kept == kKept)
      m_needed = 1;
    return m_row >= m_needed;
  }

private:
  static constexpr int kMostNeeded = 64;
  static constexpr int kKept = 4; ///< trials in a row that held, until failures are forgotten
  int m_needed = 1;               ///< frames without a turn of the host
  int m_row = 0;                  ///< that there were
  int m_kept = 0;                 ///< of those, the ones that were tried
};

} // namespace arbiter::state::software
