#pragma once
#include <GL/gl.h>

/// Records the vertices between Begin and End, and draws the primitive when it ends. Parts of a
/// very large one are drawn earlier.
namespace arbiter::state {
struct RasterContext;
}

namespace arbiter::state {

/// Begins a primitive. Returns true if it is deferred: the recorder is open, and endPrimitive()
/// will draw it or give it to the host. Returns false if the host draws, after bringing it up to
/// date. Requires isCandidate() (decision.h) and a legal mode.
[[nodiscard]] bool beginPrimitive(RasterContext &context, GLenum mode);
/// Limits the open primitive to as many vertices as a draw may have.
void limitOpen(RasterContext &context);
/// Begins another primitive behind the held ones, in a mode that is joined by indices. Returns
/// false if there is no memory; nothing has changed then.
[[nodiscard]] bool openNext(RasterContext &context);
/// Draws the recorded primitive, with those held before it (held.h). Raises OUT_OF_MEMORY if
/// vertices are missing.
void endPrimitive(RasterContext &context);
/// Draws the held primitives, when no other follows.
void endHeld(RasterContext &context);

} // namespace arbiter::state
