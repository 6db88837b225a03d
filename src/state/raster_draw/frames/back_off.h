#pragma once
#include <chrono>
#include <cstdint>

#include "state/raster_draw/frames/other_times.h"

namespace arbiter::state::software {

/// Decides by measurement whether the rasterizer or the host draws. It only doubts where pixels are
/// moved between the two in every frame, and where the rasterizer draws whole frames without a
/// program, for which the host's machine code may be the better: then some frames are drawn the one
/// way and some the other, and the faster way is kept (of frames that wait for something else, as
/// for the next tick, the one that takes less of the processor) until it is looked at again: after
/// many frames, or when frames take another time than those that it was decided by, as where an
/// application shows its title first.
class BackOff {
public:
  struct Frame {
    bool moved =
        false; ///< images went up to the host or came down in it, beyond what showing it takes
    bool plain = false; ///< all of it was fixed function, and drawn by the rasterizer
    bool keeps = false; ///< the host's would look otherwise (kept_look.h)
    /// The process's time at the frame's end; 0: not known. Only frames that are tried want it.
    std::chrono::nanoseconds processor{};
  };
  /// False: draws are the host's for now.
  [[nodiscard]] bool engaged() const { return m_phase != Phase::TryHost && m_phase != Phase::Host; }
  /// Frames are compared: those of one side are drawn now.
  [[nodiscard]] bool tries() const { return m_phase != Phase::Software && m_phase != Phase::Host; }
  /// These are frames of the rasterizer's after others of the host's: what the host drew is known
  /// by its looks.
  [[nodiscard]] bool followsHost() const {
    return m_wasHost && (m_phase == Phase::TrySoftware || m_phase == Phase::Confirm);
  }
  void frameEnded(Frame frame, std::chrono::steady_clock::time_point now);
  /// A frame ended that says nothing: the next one's time is counted from its end.
  void frameIgnored(std::chrono::steady_clock::time_point now) {
    m_before = now;
    m_hasBefore = true;
    m_processorBefore = {};
  }
  /// Off for good, or never in doubt (ARBITER_BACKEND=swrast).
  void setForced(bool forced) { m_forced = forced; }

  struct Statistics {
    std::uint64_t trials = 0;
    std::uint64_t framesBackedOff = 0;
    double lastSoftwareMilliseconds = 0,
           lastHostMilliseconds = 0; ///< a frame in the last trial
  };
  [[nodiscard]] const Statistics &statistics() const { return m_statistics; }
  /// Of a copy, whose frames are counted anew.
  void forgetStatistics() { m_statistics = {}; }

private:
  static constexpr int kTrialFrames = 8; ///< each way, at most
  static constexpr int kSureFrames = 3;  ///< that suffice where each of them says the same clearly
  static constexpr int kDoubtFrames = 8; ///< in a row, before there is a doubt
  static constexpr int kKeepFrames = 1000; ///< until the next trial
  /// The same after trials that the rasterizer won clearly, four times as long after each; and the
  /// host's frames after those that the host won clearly, twice as long, as it is not known what
  /// the rasterizer would take now.
  static constexpr int kMostKeepFrames = 64'000, kMostHostFrames = 16'000;
  /// What frames differ by through chance. Where images move the rasterizer is to be faster by more
  /// than that, as the images cost memory, and the host's caches, too; otherwise the host.
  static constexpr float kFaster = 0.96f, kClearlySlower = 1.25f;
  /// Frames before others lead to a trial: twice as many after each such trial, as an application
  /// may always have frames of several kinds.
  static constexpr int kLeastPatience = 32;
  /// Confirm: the rasterizer again, where the host was faster: frames may have changed meanwhile.
  enum class Phase : std::uint8_t { Software, TrySoftware, TryHost, Confirm, Host };

  void enter(Phase phase);
  /// A side's frames in a trial: a frame takes so long, of which the processor is busy so long.
  struct Side {
    float time = 0, busy = 0; ///< milliseconds; busy: 0 where not known
    [[nodiscard]] bool waits() const { return busy > 0 && busy * kWaits < time; }
  };
  /// A frame that takes so many times what the processor does for it waits for something else.
  static constexpr float kWaits = 2;
  /// The frames that were tried in this phase.
  [[nodiscard]] Side tried();
  /// Each frame that was tried took clearly more time than \p than, and there are enough of them.
  [[nodiscard]] bool areSlower(float than) const;
  [[nodiscard]] bool areFaster(float than) const;
  /// A frame of a trial ended. True: the phase has its answer.
  [[nodiscard]] bool isAnswered() const;
  void answer();
  void decide();
  /// The rasterizer's frames, looked at again, are clearly slower than the host's were.
  void keepHost();
  [[nodiscard]] bool isHostFaster() const;
  /// Frames of the side that was decided for take another time than those that were tried.
  [[nodiscard]] bool isStale() const { return m_others.areOthers() && m_frames > m_patience; }
  /// Ends a side's phase: the next trial begins.
  void tryAgain();

  Phase m_phase = Phase::Software;
  bool m_forced = false;
  int m_frames = 0;             ///< in this phase
  int m_tried = 0;              ///< of those, the ones whose time is in m_times
  int m_keep = kDoubtFrames;    ///< frames until a doubt is followed by a trial
  int m_keepHost = kKeepFrames; ///< the host's frames until the next trial
  bool m_looksAgain = false;    ///< a trial of what the host was kept for, by frames that are alike
  bool m_wasHost = false;       ///< a trial of frames that were the host's
  int m_moving = 0;             ///< frames in a row that moved images
  int m_plain = 0;              ///< and that were plain
  bool m_triedMoving = false;   ///< most frames of the trial moved images
  bool m_hasBefore = false;
  std::chrono::steady_clock::time_point m_before;
  std::chrono::nanoseconds m_processorBefore{};
  float m_times[kTrialFrames] = {}, m_busy[kTrialFrames] = {};
  Side m_software, m_host;
  OtherTimes m_others; ///< than a frame's of the side that was decided for
  int m_patience = kLeastPatience;
  Statistics m_statistics;
};

} // namespace arbiter::state::software
