#pragma once

namespace arbiter::state {

/// A frame differs from others if its time is this many times longer or shorter.
inline constexpr float kOtherTime = 1.5f;
/// This many such frames in a row are no chance.
inline constexpr int kOtherFrames = 8;

/// Tells when frame times differ from those on which a decision was based, as after an
/// application's title.
class OtherTimes {
public:
  /// Sets the time to compare with. \param time a frame's time; 0: nothing is decided yet
  void decide(float time) {
    m_decided = time;
    m_row = 0;
  }
  void look(float time) {
    const bool isOther =
        m_decided > 0 && (time > m_decided * kOtherTime || time * kOtherTime < m_decided);
    m_row = isOther ? m_row + 1 : 0;
  }
  /// Starts counting anew.
  void restart() { m_row = 0; }
  [[nodiscard]] bool areOthers() const { return m_row >= kOtherFrames; }

private:
  float m_decided = 0;
  int m_row = 0; ///< frames in a row that differ
};

} // namespace arbiter::state
