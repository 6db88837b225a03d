#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "apps/scene/camera.h"
#include "apps/scene/panel/panel.h"

namespace arbiter::scene {

/// Returns a value of the range at a time. At time 0 it is the value in the text, from which the
/// animation starts. A value outside its range is clamped to it.
[[nodiscard]] double animated(double value, const Parameter &parameter, double seconds);

/// Returns the x, y, z and w of a numeric parameter at a time; components that it does not set are
/// 0.
[[nodiscard]] std::array<double, 4> valueAt(const Parameter &parameter, double seconds);

/// One vec4 for GL.
struct ParameterRow {
  Setting space = Setting::Local; ///< or Env, Attrib
  unsigned index = 0;
  std::array<float, 4> value = {};
  bool operator==(const ParameterRow &) const = default;
};

/// The inputs of values that depend on cameras.
struct Surroundings {
  View view; ///< of the pass
  /// Returns the view of a target's pass; nothing if no pass has that name.
  std::function<std::optional<View>(const std::string &target)> viewOfTarget;
};

/// Returns all parameters of a panel at a time, each index once. Components that nothing sets are
/// 0.
[[nodiscard]] std::vector<ParameterRow> rowsAt(const Panel &panel, double seconds,
                                               const Surroundings &surroundings);

} // namespace arbiter::scene
