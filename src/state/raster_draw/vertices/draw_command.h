#pragma once
#include <GL/gl.h>

namespace arbiter::state {

/// A draw of `count` vertices: those from `first` on, or those that `indices` name, plus
/// `baseVertex`. Indices have the type GL_UNSIGNED_BYTE, _SHORT or _INT; the pointer is an offset
/// if an element buffer is bound.
struct DrawCommand {
  GLenum mode = GL_TRIANGLES;
  GLint first = 0;
  GLsizei count = 0;
  GLenum indexType = 0; ///< 0: no indices
  const void *indices = nullptr;
  GLint baseVertex = 0;
};

/// A multi-draw command. `count` and every other array that is not null have `drawCount` elements.
/// `first`, `indices` and `baseVertices` may be null.
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

} // namespace arbiter::state
