#pragma once
#include <algorithm>
#include <cstdint>

namespace arbiter::state::software {

/// The side that draws what the two draw otherwise (looks.h). The first such draw decides, and it
/// stays so: the rasterizer where the frame is its own, the host where the frame is a mixed one, or
/// where the host was faster and drew the frames before. A frame may have been a mixed one by
/// chance, so the host's looks are chosen anew after many frames in which they alone were the
/// host's; each time after twice as many, unless the rasterizer kept them for long in between.
class KeptLook {
public:
  enum class Side : std::uint8_t { Undecided, Rasterizer, Host };
  [[nodiscard]] Side side() const { return m_side; }
  [[nodiscard]] bool isRasterizers() const { return m_side == Side::Rasterizer; }
  [[nodiscard]] bool isHosts() const { return m_side == Side::Host; }

  /// Before a draw that has a look.
  void meets(bool hostDrewBefore) {
    if (m_side == Side::Undecided)
      m_side = hostDrewBefore ? Side::Host : Side::Rasterizer;
  }
  /// The host draws one, or may do so unseen.
  void becomesHosts() {
    if (m_held >= kLong * m_needed)
      m_needed = kLeastNeeded;
    m_side = Side::Host;
    m_row = m_held = 0;
  }
  /// \param whole all but looks was the rasterizer's, or would have been
  /// \return whether the next frame is to be tried as a whole one
  bool frameEnded(bool whole) {
    m_held = m_side == Side::Rasterizer ? std::min(m_held + 1, kLong * kMostNeeded) : 0;
    m_row = m_side == Side::Host && whole ? m_row + 1 : 0;
    if (m_row < m_needed)
      return false;
    m_needed = std::min(2 * m_needed, kMostNeeded);
    m_row = 0;
    m_side = Side::Undecided;
    return true;
  }

private:
  static constexpr int kLeastNeeded = 64, kMostNeeded = 4096;
  static constexpr int kLong = 16; ///< times as many frames
  Side m_side = Side::Undecided;
  int m_needed = kLeastNeeded; ///< frames in a row, until the host's looks are chosen anew
  int m_row = 0;               ///< that there were
  int m_held = 0;              ///< frames in a row for which looks were the rasterizer's
};

} // namespace arbiter::state::software
