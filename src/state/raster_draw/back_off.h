#pragma once
#include <chrono>
#include <cstdint>

namespace arbiter::state::software {

/// Decides by measurement whether the rasterizer or the host draws. It only doubts where pixels are
/// moved between the two in every frame: then some frames are drawn the one way and some the other,
/// and the faster way is kept until it is looked at again.
class BackOff {
public:
  /// False: draws are the host's for now.
  [[nodiscard]] bool engaged() const { return m_phase != Phase::TryHost && m_phase != Phase::Host; }
  /// At the end of a frame. \param moved images went up to the host or came down in it, beyond what
  /// showing the frame takes
  void frameEnded(bool moved, std::chrono::steady_clock::time_point now);
  /// Off for good, or never in doubt (ARBITER_BACKEND=swrast).
  void setForced(bool forced) { m_forced = forced; }

  struct Statistics {
    std::uint64_t trials = 0;
    std::uint64_t framesBackedOff = 0;
    double lastSoftwareMilliseconds = 0,
           lastHostMilliseconds = 0; ///< a frame's median in the last trial
  };
  [[nodiscard]] const Statistics &statistics() const { return m_statistics; }

private:
  static constexpr int kTrialFrames = 7;   ///< each way
  static constexpr int kMovingFrames = 8;  ///< in a row, before there is a doubt
  static constexpr int kKeepFrames = 1000; ///< until the next trial
  enum class Phase : std::uint8_t { Software, TrySoftware, TryHost, Host };

  void enter(Phase phase);
  void decide();

  Phase m_phase = Phase::Software;
  bool m_forced = false;
  int m_frames = 0; ///< in this phase
  int m_moving = 0; ///< frames in a row that moved images
  bool m_hasBefore = false;
  std::chrono::steady_clock::time_point m_before;
  float m_times[kTrialFrames] = {};
  float m_softwareTime = 0;
  Statistics m_statistics;
};

} // namespace arbiter::state::software
