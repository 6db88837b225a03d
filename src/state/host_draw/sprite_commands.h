#pragma once
#include <GL/gl.h>

namespace arbiter::state {

struct DrawContext;

/// Notes a draw's primitive mode (notePrimitiveMode()). In a list, records where points and other
/// primitives change.
void issuePrimitiveMode(DrawContext &context, GLenum mode);
/// Records TexEnv of POINT_SPRITE in a list. It is a command of the layer's, as the host's
/// COORD_REPLACE may differ from the application's (programs/variants/point_sprites.h). Returns
/// false if the host must execute it.
[[nodiscard]] bool recordCoordReplace(DrawContext &context, GLenum pname, GLint value);
/// Cuts a list after a command that may change whether sprites are drawn.
void noteSpriteCommand(DrawContext &context);

} // namespace arbiter::state
