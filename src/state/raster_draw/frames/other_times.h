#pragma once

namespace arbiter::state::software {

/// A frame is another one if it takes so many times the time, or such a part of it.
inline constexpr float kOtherTime = 1.5f;
/// The number of such frames in a row that is no chance.
inline constexpr int kOtherFrames = 8;

/// Tells when an application's frames are others than those that something was decided by, as where
/// it shows its title first.
class OtherTimes {
public:
  /// \param time a frame's; 0: nothing is decided yet
  void decide(float time) {
    m_decided = time;
    m_row = 0;
  }
  void look(float time) {
    const bool isOther =
        m_decided > 0 && (time > m_decided * kOtherTime || time * kOtherTime < m_decided);
    m_row = isOther ? m_row + 1 : 0;
  }
  /// Another row begins.
  void restart() { m_row = 0; }
  [[nodiscard]] bool areOthers() const { return m_row >= kOtherFrames; }

private:
  float m_decided = 0;
  int m_row = 0; ///< of other frames
};

} // namespace arbiter::state::software
