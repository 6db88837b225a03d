#pragma once
#include <array>
#include <optional>

#include "apps/tools/debug/trace/condition.h"

namespace arbiter::tools::debug {

/// The draw to debug, as GL calls in a current context.
class Subject {
public:
  virtual ~Subject() = default;
  /// Returns the size of the draw's target in pixels.
  [[nodiscard]] virtual std::array<int, 2> size() const = 0;
  /// Loads everything and draws the earlier frames and passes. Then sets the state of the draw:
  /// programs, tests, viewport, target.
  [[nodiscard]] virtual std::optional<DebugError> prepare() = 0;
  /// Draws the mesh of the draw, any number of times. Changes nothing but pixels.
  virtual void drawMesh() = 0;
  /// Clears color and depth of the bound target as the draw's pass does. False if the pass draws
  /// over existing content.
  virtual bool clear() = 0;
  /// Leaves only the tests and writes that decide which fragment is visible: no blending, no color
  /// masks.
  virtual void setPlainState() = 0;
};

} // namespace arbiter::tools::debug
