#pragma once
#include <cstdint>

#include <GL/gl.h>

#include "state/core/context.h"

/// Primitives of Begin and End that follow one another, drawn as one: of some applications each
/// triangle is a primitive. Points, lines, triangles and quads share no vertices, so several of a
/// mode are one with all their vertices (OpenGL 2.1, 2.6.1); the others are joined by indices
/// (joined.h). After End such a primitive is held:
/// the recorder stays, attributes go to it, and another Begin of the mode opens it anew. Every
/// other command has it drawn first (attention::kHeld), by its generated entry point, and so has
/// what the window system is asked for.
namespace arbiter::state::software {

/// More vertices are not held, so that other threads get to work.
inline constexpr std::uint32_t kMostHeld = 3072;

[[nodiscard]] inline bool isHeld(const ContextHot &hot) {
  return (hot.attention & attention::kHeld) != 0;
}
/// At End, while the primitive is recorded. False: it is none that can be held, and must end.
[[nodiscard]] bool holdPrimitive(Context &context);
/// At Begin: true if the held primitive is open again. False: nothing is held any more.
[[nodiscard]] bool reopenHeld(Context &context, GLenum mode);
/// Draws the primitive that is held. Requires: held.
[[gnu::cold]] void drawHeld(ContextHot &hot);

/// Whom the application asks what is no part of a list: while one is compiled, the host behind what
/// stands in for it.
[[nodiscard]] const host::HostTable *answeringHost(ContextHot &hot);

} // namespace arbiter::state::software
