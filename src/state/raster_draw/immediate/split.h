#pragma once
#include <GL/gl.h>

#include "state/core/context_hot.h"

/// Splits a recorded primitive for commands between Begin and End that are neither attributes nor
/// vertices, but legal: glMaterial.
namespace arbiter::state {

/// Suspends a recorded primitive while it lives, so that the host's state can be set outside of
/// Begin and End. The part so far is drawn, and the rest is recorded as another primitive of the
/// same mode. This is equivalent if primitives share no vertices and the part holds whole ones:
/// points, lines, triangles and quads, or nothing yet (OpenGL 2.1, 2.6.1). In all other cases it
/// does nothing, and the host gets the primitive as far as it goes (replay.h).
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

  ContextHot *m_hot = nullptr; ///< null: no primitive was split
  GLenum m_mode = 0;
};

} // namespace arbiter::state
