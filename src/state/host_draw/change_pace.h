#pragma once
#include <chrono>

namespace arbiter::state {

/// Measures how quickly draws follow each other for which fragment program parameters changed. A
/// context has one while its fragment programs are the host's own. NVIDIA's driver takes 0.29
/// microseconds longer for such a draw than with GLSL.
class ChangePace {
public:
  using Clock = std::chrono::steady_clock;
  /// Draws between two readings of the clock. Fewer draws are no reason to compile a program again.
  static constexpr unsigned kDraws = 256;
  /// If such draws are closer together than this, they cost more than a hundredth of the time.
  static constexpr std::chrono::microseconds kApart{30};

  /// Counts a draw. True for each kDraws-th one, if these came less than kApart apart.
  [[nodiscard]] bool isFast() { return ++m_draws >= kDraws && isFast(Clock::now()); }
  /// Handles the last of kDraws draws, with the time of now. True if they came less than kApart
  /// apart.
  [[nodiscard]] bool isFast(Clock::time_point now) {
    const bool fast = m_since != Clock::time_point() && now - m_since < kDraws * kApart;
    m_draws = 0;
    m_since = now;
    return fast;
  }

private:
  unsigned m_draws = 0;
  Clock::time_point m_since; ///< when the clock was last read; 0: never
};

} // namespace arbiter::state
