#pragma once
#include <chrono>
#include <cstdint>

#include "state/raster_draw/frames/other_times.h"

namespace arbiter::state {

/// Decides by measurement whether the rasterizer or the host draws.
///
/// It makes a trial in two cases. The first is that pixels are moved between the two in every
/// frame. The second is that the rasterizer draws whole frames of fixed function, for which the
/// host's machine code may be better. A trial draws some frames each way and keeps the faster one.
/// If frames wait for something else, such as the next tick, the way that uses less of the
/// processor is kept.
///
/// The next trial comes after many frames, or when frames take a different time than those of the
/// trial, as after an application's title.
class BackOff {
public:
  struct Frame {
    bool moved =
        false; ///< images were moved between host and shadows, beyond what showing the frame needs
    bool plain = false; ///< the rasterizer drew all of it, with fixed function alone
    bool keeps = false; ///< the host's frames would look different (kept_look.h)
    /// The process's processor time at the end of the frame; 0: not known. Only trials need it.
    std::chrono::nanoseconds processor{};
  };
  /// True if the rasterizer draws now, false if the host does.
  [[nodiscard]] bool engaged() const { return m_phase != Phase::TryHost && m_phase != Phase::Host; }
  /// True during a trial.
  [[nodiscard]] bool tries() const { return m_phase != Phase::Software && m_phase != Phase::Host; }
  /// True if the rasterizer's frames are tried after frames of the host. The looks of these are the
  /// host's.
  [[nodiscard]] bool followsHost() const {
    return m_wasHost && (m_phase == Phase::TrySoftware || m_phase == Phase::Confirm);
  }
  void frameEnded(Frame frame, std::chrono::steady_clock::time_point now);
  /// Skips a frame that says nothing. The next frame is timed from its end.
  void frameIgnored(std::chrono::steady_clock::time_point now) {
    m_before = now;
    m_hasBefore = true;
    m_processorBefore = {};
  }
  /// Switches trials off for good (ARBITER_BACKEND=swrast).
  void setForced(bool forced) { m_forced = forced; }

  struct Statistics {
    std::uint64_t trials = 0;
    std::uint64_t framesBackedOff = 0;
    double lastSoftwareMilliseconds = 0,
           lastHostMilliseconds = 0; ///< time of a frame in the last trial
  };
  [[nodiscard]] const Statistics &statistics() const { return m_statistics; }
  /// Clears the statistics of a copy, whose frames are counted anew.
  void forgetStatistics() { m_statistics = {}; }

private:
  static constexpr int kTrialFrames = 8;   ///< most frames tried each way
  static constexpr int kSureFrames = 3;    ///< enough frames if each of them clearly says the same
  static constexpr int kDoubtFrames = 8;   ///< frames in a row with a reason for a trial
  static constexpr int kKeepFrames = 1000; ///< frames until the next trial
  /// Most frames until the next trial. The rasterizer's number grows fourfold after each trial that
  /// it clearly won. The host's number doubles after each trial that the host clearly won, because
  /// the rasterizer's time is not known meanwhile.
  static constexpr int kMaxKeepFrames = 64'000, kMaxHostFrames = 16'000;
  /// The factor that chance may explain, and a clear difference. If images are moved, the
  /// rasterizer must be faster by more than chance, because the images also cost memory and the
  /// host's caches. Otherwise the host must.
  static constexpr float kFaster = 0.96f, kClearlySlower = 1.25f;
  /// Frames before a change of frame times leads to a trial. The number doubles after each such
  /// trial, because an application may always alternate between several kinds of frames.
  static constexpr int kLeastPatience = 32;
  /// Confirm tries the rasterizer again after the host was faster, because the frames may have
  /// changed meanwhile.
  enum class Phase : std::uint8_t { Software, TrySoftware, TryHost, Confirm, Host };

  void enter(Phase phase);
  /// The result of one side in a trial: the time of a frame, and the processor time in it.
  struct Side {
    float time = 0, busy = 0; ///< in milliseconds; busy: 0 if not known
    [[nodiscard]] bool waits() const { return busy > 0 && busy * kWaits < time; }
  };
  /// A frame waits for something else if it takes this many times its processor time.
  static constexpr float kWaits = 2;
  /// Returns the result of the frames tried in this phase.
  [[nodiscard]] Side tried();
  /// True if enough frames were tried and each clearly took more time than \p than.
  [[nodiscard]] bool areSlower(float than) const;
  [[nodiscard]] bool areFaster(float than) const;
  /// True if the frames of this phase suffice for an answer.
  [[nodiscard]] bool isAnswered() const;
  void answer();
  void decide();
  /// Keeps the host, because the rasterizer's frames are still clearly slower.
  void keepHost();
  [[nodiscard]] bool isHostFaster() const;
  /// True if frames take a different time than those of the trial.
  [[nodiscard]] bool isStale() const { return m_others.areOthers() && m_frames > m_patience; }
  /// Begins the next trial.
  void tryAgain();

  Phase m_phase = Phase::Software;
  bool m_forced = false;
  int m_frames = 0;             ///< number in this phase
  int m_tried = 0;              ///< number of times in m_times
  int m_keep = kDoubtFrames;    ///< frames until a reason leads to a trial
  int m_keepHost = kKeepFrames; ///< the host's frames until the next trial
  /// true if frames like those for which the host was kept are tried again
  bool m_looksAgain = false;
  bool m_wasHost = false;     ///< true if the host drew before this trial
  int m_moving = 0;           ///< frames in a row that moved images
  int m_plain = 0;            ///< frames in a row that were plain
  bool m_triedMoving = false; ///< true if most frames of the trial moved images
  bool m_hasBefore = false;
  std::chrono::steady_clock::time_point m_before;
  std::chrono::nanoseconds m_processorBefore{};
  float m_times[kTrialFrames] = {}, m_busy[kTrialFrames] = {};
  Side m_software, m_host;
  OtherTimes m_others; ///< tells when frames differ from those of the trial
  int m_patience = kLeastPatience;
  Statistics m_statistics;
};

} // namespace arbiter::state
