#include "state/mirror/attributes.h"

#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

std::uint32_t elementBytes(const VertexSource::Array &array) {
  switch (array.type) {
  case GL_BYTE:
  case GL_UNSIGNED_BYTE:
    return array.components;
  case GL_SHORT:
  case GL_UNSIGNED_SHORT:
  case GL_HALF_FLOAT:
    return 2u * array.components;
  case GL_INT:
  case GL_UNSIGNED_INT:
  case GL_FLOAT:
  case GL_FIXED:
    return 4u * array.components;
  case GL_DOUBLE:
    return 8u * array.components;
  case GL_INT_2_10_10_10_REV:
  case GL_UNSIGNED_INT_2_10_10_10_REV:
    return 4;
  default:
    return 0;
  }
}

} // namespace arbiter::state
