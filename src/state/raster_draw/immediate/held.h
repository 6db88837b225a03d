#pragma once
#include <cstdint>

#include <GL/gl.h>

#include "state/raster_draw/raster_context.h"

/// Holds ended primitives of Begin and End, so that several can be drawn as one. Old applications
/// make a primitive of each triangle. Points, lines, triangles and quads share no vertices, so
/// several are one primitive with all their vertices (OpenGL 2.1, 2.6.1). Other modes are joined by
/// indices (joined.h).
///
/// After End, the recorder stays open for attributes, and another Begin of the same mode continues
/// it. Every other command first draws the held primitives: its generated entry point tests
/// attention::kHeld. Requests to the window system do the same.
namespace arbiter::state {

/// Most vertices that are held. After more, the other threads should begin to draw.
inline constexpr std::uint32_t kMaxHeld = 3072;

[[nodiscard]] inline bool isHeld(const ContextHot &hot) {
  return (hot.attention & attention::kHeld) != 0;
}
/// Holds the recorded primitive at End. Returns false if it cannot be held and must be drawn.
[[nodiscard]] bool holdPrimitive(RasterContext &context);
/// Continues the held primitive at Begin. Returns false if nothing is held any more.
[[nodiscard]] bool reopenHeld(RasterContext &context, GLenum mode);
/// Draws the held primitives. Requires isHeld().
[[gnu::cold]] void drawHeld(ContextHot &hot);

/// Returns the host's table for queries, which are never part of a list. It is the real host, even
/// while a display list redirects calls to a recorder.
[[nodiscard]] const host::HostTable *answeringHost(ContextHot &hot);

} // namespace arbiter::state
