#pragma once
#include <GL/gl.h>

namespace arbiter::state {

class Context;

/// Called before a command gives an image an internal format. After the first depth format, draws
/// of register combiners check which of their textures hold depths. For other formats this costs
/// one comparison.
void noteInternalFormat(Context &context, GLenum internalFormat);

} // namespace arbiter::state
