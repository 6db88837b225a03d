#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/ir/interface.h"

namespace arbiter::state {

/// The names that GL has for what an image unit samples.
struct TextureNames {
  GLenum target; ///< of binds and parameters
  GLenum level;  ///< of levels: of a cube map its first face
};
[[nodiscard]] TextureNames textureNames(fp::ir::TexTarget target);

} // namespace arbiter::state
