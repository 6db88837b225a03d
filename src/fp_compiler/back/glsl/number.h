#pragma once
#include <string>

namespace arbiter::fp::glsl {

/// A GLSL 1.20 float expression whose value is exactly \p value on a host that parses decimals
/// correctly: the shortest digits that round back. Infinities become a division by zero, NaN zero
/// by zero. A denormal is written out; hosts that flush it agree with ir/semantics.h.
[[nodiscard]] std::string number(float value);

} // namespace arbiter::fp::glsl
