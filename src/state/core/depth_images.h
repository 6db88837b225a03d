#pragma once
#include <GL/gl.h>

namespace arbiter::state {

struct CoreContext;

/// Notes the internal format that a command is about to give an image. After the first depth
/// format, draws of register combiners check which of their textures hold depths. For other formats
/// this costs one comparison.
void noteInternalFormat(CoreContext &context, GLenum internalFormat);

} // namespace arbiter::state
