#pragma once
#include <vector>

#include <GL/gl.h>

#include "state/imaging/statistics.h"

namespace arbiter::state {

class Context;

/// A histogram's counters as an image of one row in the application's memory or pixel buffer:
/// whole numbers of any type, clamped to its range, and no fractions of it (OpenGL 2.1, 6.1.9).
/// Errors are raised. False: nothing was written.
[[nodiscard]] bool packCounts(Context &context, const std::vector<imaging::Counts> &bins,
                              GLenum format, GLenum type, void *to);

} // namespace arbiter::state
