#pragma once
#include <GL/gl.h>

namespace arbiter::state {

class Context;

/// notePrimitiveMode() of a draw that may go into a list, which then says where draws of points and
/// others change.
void issuePrimitiveMode(Context &context, GLenum mode);
/// TexEnv of POINT_SPRITE is a command of the layer's in a list, as the host's value of
/// COORD_REPLACE is not always the application's (programs/variants/point_sprites.h). False: it is
/// the host's.
[[nodiscard]] bool recordCoordReplace(Context &context, GLenum pname, GLint value);
/// After what may change whether sprites are drawn: a list is cut behind it.
void noteSpriteCommand(Context &context);

} // namespace arbiter::state
