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

/// Several draws that are one command. Requires: all arrays are as long as `drawCount`; `first` or
/// `indices` may be null, and `baseVertices`.
struct MultiDraw {
  GLenum mode;
  const GLint *first;
  const GLsizei *count;
  GLsizei drawCount;
  GLenum indexType = 0;
  const void *const *indices = nullptr;
  const GLint *baseVertices = nullptr;

  [[nodiscard]] DrawCommand at(GLsizei i) const {
    return {.mode = mode,
            .first = first ? first[i] : 0,
            .count = count[i],
            .indexType = indexType,
            .indices = indices ? indices[i] : nullptr,
            .baseVertex = baseVertices ? baseVertices[i] : 0};
  }
};

} // namespace arbiter::state::software
