#pragma once
#include <chrono>

namespace arbiter::state {

/// How fast draws follow each other before which parameters of fragment programs changed, of a
/// context and while those are the host's own. NVIDIA's driver takes 0.29 microseconds longer for
/// such a draw than by GLSL.
class ChangePace {
public:
  using Clock = std::chrono::steady_clock;
  /// The clock is read once in so many draws; and few are no reason to compile a program again.
  static constexpr unsigned kDraws = 256;
  /// Apart from each other by less, they take more than a hundredth of the time.
  static constexpr std::chrono::microseconds kApart{30};

  /// Another one. True of each kDraws-th, where these were less than kApart apart.
  [[nodiscard]] bool isFast() { return ++m_draws >= kDraws && isFast(Clock::now()); }
  /// The same of the last of kDraws.
  [[nodiscard]] bool isFast(Clock::time_point now) {
    const bool fast = m_since != Clock::time_point() && now - m_since < kDraws * kApart;
    m_draws = 0;
    m_since = now;
    return fast;
  }

private:
  unsigned m_draws = 0;
  Clock::time_point m_since; ///< the last time that the clock was read; 0: never yet
};

} // namespace arbiter::state
