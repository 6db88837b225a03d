#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/ir/interface.h"

namespace arbiter::state {

/// The GL enums for what an image unit samples.
struct TextureNames {
  GLenum target; ///< for binds and parameters
  GLenum level;  ///< for levels: of a cube map, the first face
};
[[nodiscard]] TextureNames textureNames(fp::ir::TexTarget target);

} // namespace arbiter::state
