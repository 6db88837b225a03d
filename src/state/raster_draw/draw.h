#pragma once
#include <cstdint>

#include <GL/gl.h>

#include "state/mirror/attributes.h"
#include "state/raster_draw/outcome.h"
#include "state/raster_draw/vertices/draw_command.h"

/// Draws of arrays and of vertices that a list has kept.
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

// --- Commands. True: drawn. Called where mayDraw() (commands.h), before anything is prepared for
// the
// --- host's draw; false also where the host would raise an error for the arguments: it does so ---

/// One draw, of arrays or of elements.
[[nodiscard]] bool tryDraw(Context &context, const DrawCommand &command);
[[nodiscard]] bool tryDrawRange(Context &context, GLuint start, GLuint end,
                                const DrawCommand &command);
/// Each of its draws is judged by itself: some may be the rasterizer's, and others the host's.
[[nodiscard]] bool tryMultiDrawArrays(Context &context, GLenum mode, const GLint *first,
                                      const GLsizei *count, GLsizei drawCount);
/// \param baseVertices null: 0 for each
[[nodiscard]] bool tryMultiDrawElements(Context &context, GLenum mode, const GLsizei *count,
                                        GLenum type, const void *const *indices, GLsizei drawCount,
                                        const GLint *baseVertices);

/// Draws the first `count` vertices of `source` with what decide() (decision.h) has chosen. Not ok:
/// nothing has been drawn.
Outcome drawSource(Context &context, const VertexSource &source, std::uint32_t count);

} // namespace arbiter::state::software
