#pragma once
#include "state/raster_draw/fallback.h"

/// The outcome of a step of a draw: success, or the reason why the host draws.
namespace arbiter::state {

class [[nodiscard]] Outcome {
public:
  constexpr Outcome() = default;
  constexpr Outcome(Fallback reason) : m_reason(reason), m_ok(false) {} // NOLINT: reads as a value
  [[nodiscard]] constexpr bool ok() const { return m_ok; }
  /// Returns the reason. Requires that the outcome is not ok.
  [[nodiscard]] constexpr Fallback reason() const { return m_reason; }

private:
  Fallback m_reason = Fallback::State;
  bool m_ok = true;
};

} // namespace arbiter::state
