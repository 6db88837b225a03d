#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "scene/camera.h"
#include "scene/panel/panel.h"

namespace arbiter::scene {

/// A value of the range at a time: at 0 it is the one that the text has, from where the animation
/// goes on. A value outside its range is taken to its nearer end.
[[nodiscard]] double animated(double value, const Parameter &parameter, double seconds);

/// The x, y, z and w of a parameter of numbers at a time; 0 where it has none.
[[nodiscard]] std::array<double, 4> valueAt(const Parameter &parameter, double seconds);

/// One vec4 for GL.
struct ParameterRow {
  Setting space = Setting::Local; ///< or Env, Attrib
  unsigned index = 0;
  std::array<float, 4> value = {};
  bool operator==(const ParameterRow &) const = default;
};

/// What values that follow from cameras are made of.
struct Surroundings {
  View view; ///< of the pass
  /// The view of a target's pass; nothing of a name that no pass has.
  std::function<std::optional<View>(const std::string &target)> viewOfTarget;
};

/// All parameters of a panel at a time, each index once; components that nothing sets are 0.
[[nodiscard]] std::vector<ParameterRow> rowsAt(const Panel &panel, double seconds,
                                               const Surroundings &surroundings);

} // namespace arbiter::scene
