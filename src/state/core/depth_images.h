#pragma once
#include <GL/gl.h>

namespace arbiter::state {

class Context;

/// Before a command that gives an image an internal format: once one of depths was asked for, draws
/// of register combiners ask which of their textures are depths. One comparison where there is no
/// such format, as of nearly all images.
void noteInternalFormat(Context &context, GLenum internalFormat);

} // namespace arbiter::state
