#pragma once
#include <string>

#include "backend.h"
#include "gl_host.h"

namespace arbiter::differential {

/// Draws a quad with a user clip plane by fixed function, and by vertex programs with and without
/// ARB_position_invariant: all must cover the same pixels. Returns the first difference, or "".
/// Changes the matrices.
[[nodiscard]] std::string clipDifference(Backend &backend, const FloatTarget &target);

} // namespace arbiter::differential
