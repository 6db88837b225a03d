#include "state/core/texture_binding.h"

#include <GL/glext.h>

namespace arbiter::state {

GLenum bindingOf(GLenum target) {
  switch (target) {
  case GL_TEXTURE_1D:
    return GL_TEXTURE_BINDING_1D;
  case GL_TEXTURE_2D:
    return GL_TEXTURE_BINDING_2D;
  case GL_TEXTURE_3D:
    return GL_TEXTURE_BINDING_3D;
  case GL_TEXTURE_RECTANGLE:
    return GL_TEXTURE_BINDING_RECTANGLE;
  default:
    return target >= GL_TEXTURE_CUBE_MAP_POSITIVE_X && target <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z
               ? GL_TEXTURE_BINDING_CUBE_MAP
               : 0;
  }
}

} // namespace arbiter::state
