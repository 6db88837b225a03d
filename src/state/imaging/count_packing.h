#pragma once
#include <vector>

#include <GL/gl.h>

#include "state/imaging/statistics.h"

namespace arbiter::state {

struct CoreContext;

/// Writes a histogram's counters as an image of one row to memory or the pixel buffer. They are
/// integers of any type, clamped to its range and not scaled (OpenGL 2.1, 6.1.9). Raises errors.
/// Returns false if nothing was written.
[[nodiscard]] bool packCounts(CoreContext &context, const std::vector<imaging::Counts> &bins,
                              GLenum format, GLenum type, void *to);

} // namespace arbiter::state
