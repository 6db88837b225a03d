#pragma once
#include <string>

namespace arbiter::fp::glsl {

/// Returns a GLSL 1.20 float expression with exactly the value \p value, if the host parses
/// decimals correctly. It has the shortest digits that round back. Infinities become a division by
/// zero, and NaN zero by zero. Denormals are written out; hosts that flush them agree with
/// ir/semantics.h.
[[nodiscard]] std::string number(float value);

} // namespace arbiter::fp::glsl
