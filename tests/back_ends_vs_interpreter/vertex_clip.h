#pragma once
#include <string>

#include "backend.h"
#include "gl_host.h"

namespace arbiter::differential {

/// Draws a quad under a user clip plane by fixed function, and by vertex programs with and without
/// ARB_position_invariant: all must cover the same pixels. The first difference, or nothing. Leaves
/// the matrices changed.
[[nodiscard]] std::string clipDifference(Backend &backend, const FloatTarget &target);

} // namespace arbiter::differential
