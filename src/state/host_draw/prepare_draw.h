#pragma once
#include <GL/gl.h>

/// What runs before a draw of the host's whose context asks for attention (ContextHot::attention).
namespace arbiter::state {

struct DrawContext;

/// Validates what is effective, and gives it to the host. Returns false if the draw is dropped,
/// with its error raised.
/// \param mode the kind of primitive; PointSprites::kNoPrimitive where it has none
[[nodiscard]] bool prepareDraw(DrawContext &context, GLenum mode);
/// As prepareDraw(), for a command that shades fragments and transforms no vertex.
[[nodiscard]] bool preparePixels(DrawContext &context);
/// As prepareDraw(), for RasterPos, which transforms a vertex and draws nothing.
[[nodiscard]] bool prepareRasterPos(DrawContext &context);

} // namespace arbiter::state
