#pragma once
#include <GL/gl.h>

namespace arbiter::state::software {

/// `count` vertices from `first`, or by `indices` (of type GL_UNSIGNED_BYTE, _SHORT, _INT; an
/// offset into the element buffer where one is bound) with `baseVertex` added.
struct DrawCommand {
  GLenum mode = GL_TRIANGLES;
  GLint first = 0;
  GLsizei count = 0;
  GLenum indexType = 0; ///< 0: no indices
  const void *indices = nullptr;
  GLint baseVertex = 0;
};

} // namespace arbiter::state::software
