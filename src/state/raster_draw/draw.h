#pragma once
#include <cstdint>

#include <GL/gl.h>

#include "state/mirror/attributes.h"
#include "state/raster_draw/outcome.h"
#include "state/raster_draw/vertices/draw_command.h"

/// Draws arrays, and vertices that a list has kept.
namespace arbiter::state {
struct RasterContext;
}

namespace arbiter::state {

// --- Commands. They return true if drawn, and are called only if mayDraw() (commands.h), before
// anything is prepared for the host's draw. They return false for invalid arguments too, for which
// the host raises the error. ---

/// Executes a draw of arrays or elements.
[[nodiscard]] bool tryDraw(RasterContext &context, const DrawCommand &command);
[[nodiscard]] bool tryDrawRange(RasterContext &context, GLuint start, GLuint end,
                                const DrawCommand &command);
/// Executes a multi-draw. Each of its draws is decided on its own, so either side may do it.
[[nodiscard]] bool tryMultiDrawArrays(RasterContext &context, GLenum mode, const GLint *first,
                                      const GLsizei *count, GLsizei drawCount);
/// \param baseVertices null: 0 for each draw
[[nodiscard]] bool tryMultiDrawElements(RasterContext &context, GLenum mode, const GLsizei *count,
                                        GLenum type, const void *const *indices, GLsizei drawCount,
                                        const GLint *baseVertices);

/// Draws the first `count` vertices of `source` as decide() (decision.h) has chosen. If the outcome
/// is not ok, nothing has been drawn.
Outcome drawSource(RasterContext &context, const VertexSource &source, std::uint32_t count);

} // namespace arbiter::state
