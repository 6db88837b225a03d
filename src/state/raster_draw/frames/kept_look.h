#pragma once
#include <algorithm>
#include <cstdint>

namespace arbiter::state {

/// Keeps the side that draws a context's looks: features that the two sides draw differently
/// (looks.h). The first such draw decides. The rasterizer gets them if the frame is its own. The
/// host gets them in mixed frames, or if back-off kept the host for the frames before. A frame may
/// be mixed by chance, so the host's choice is dropped after many frames in which looks were all
/// that the host drew. Each time it takes twice as many frames, unless the rasterizer kept the
/// looks for long in between.
class KeptLook {
public:
  enum class Side : std::uint8_t { Undecided, Rasterizer, Host };
  [[nodiscard]] Side side() const { return m_side; }
  [[nodiscard]] bool isRasterizers() const { return m_side == Side::Rasterizer; }
  [[nodiscard]] bool isHosts() const { return m_side == Side::Host; }

  /// Chooses the side, if there is none yet, before a draw that has a look.
  void meets(bool hostDrewBefore) {
    if (m_side == Side::Undecided)
      m_side = hostDrewBefore ? Side::Host : Side::Rasterizer;
  }
  /// Gives looks to the host, because it draws one, or may do so unnoticed.
  void becomesHosts() {
    if (m_held >= kLong * m_needed)
      m_needed = kLeastNeeded;
    m_side = Side::Host;
    m_row = m_held = 0;
  }
  /// Handles the end of a frame.
  /// \param whole true if the host drew nothing but looks
  /// \return true if the next frame is to be tried as a whole one
  bool frameEnded(bool whole) {
    m_held = m_side == Side::Rasterizer ? std::min(m_held + 1, kLong * kMaxNeeded) : 0;
    m_row = m_side == Side::Host && whole ? m_row + 1 : 0;
    if (m_row < m_needed)
      return false;
    m_needed = std::min(2 * m_needed, kMaxNeeded);
    m_row = 0;
    m_side = Side::Undecided;
    return true;
  }

private:
  static constexpr int kLeastNeeded = 64, kMaxNeeded = 4096;
  static constexpr int kLong = 16; ///< m_held counts as long from this multiple of m_needed on
  Side m_side = Side::Undecided;
  int m_needed = kLeastNeeded; ///< frames in a row until the host's looks are chosen anew
  int m_row = 0;               ///< such frames so far
  int m_held = 0;              ///< frames in a row in which the rasterizer had the looks
};

} // namespace arbiter::state
