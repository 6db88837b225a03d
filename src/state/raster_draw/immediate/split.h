#pragma once
#include <GL/gl.h>

#include "state/core/context_hot.h"

/// Commands between Begin and End that are neither attributes nor vertices, but legal: glMaterial.
namespace arbiter::state::software {

/// While one lives, a primitive that is recorded is not: the host is outside of Begin and End and
/// its state may be set. What there is of the primitive has been drawn, and what follows is
/// recorded as another of the same mode, which is equal where primitives share no vertices and what
/// there is makes whole ones: points, lines, triangles and quads, or nothing yet
/// (OpenGL 2.1, 2.6.1). In any other case nothing is done here, and the host is given the primitive
/// as far as it is there (replay.h).
class PrimitiveSplit {
public:
  explicit PrimitiveSplit(ContextHot &hot) {
    if (hot.recorder) [[unlikely]]
      open(hot);
  }
  ~PrimitiveSplit() {
    if (m_hot) [[unlikely]]
      close();
  }
  PrimitiveSplit(const PrimitiveSplit &) = delete;
  PrimitiveSplit &operator=(const PrimitiveSplit &) = delete;

private:
  void open(ContextHot &hot);
  void close();

  ContextHot *m_hot = nullptr; ///< where a primitive is split
  GLenum m_mode = 0;
};

} // namespace arbiter::state::software
