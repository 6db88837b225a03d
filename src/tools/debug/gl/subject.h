#pragma once
#include <array>
#include <optional>

#include "tools/debug/trace/condition.h"

namespace arbiter::tools::debug {

/// The draw that is looked into, as GL calls in a current context.
class Subject {
public:
  virtual ~Subject() = default;
  /// Pixels of the draw's target.
  [[nodiscard]] virtual std::array<int, 2> size() const = 0;
  /// Loads all, and draws what comes before: earlier frames and passes. The state is then that of
  /// the draw: programs bound and enabled, tests, viewport; the target is bound.
  [[nodiscard]] virtual std::optional<DebugError> prepare() = 0;
  /// The draw's mesh alone. Called any number of times; changes nothing but pixels.
  virtual void drawMesh() = 0;
  /// Empties colour and depth of the bound target as the draw's pass begins; false where the pass
  /// draws over what is there.
  virtual bool clear() = 0;
  /// Tests and writes only what decides which fragment is seen: no blending, no masks of colours.
  virtual void setPlainState() = 0;
};

} // namespace arbiter::tools::debug
