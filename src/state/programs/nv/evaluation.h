#pragma once
#include <array>
#include <vector>

#include "state/programs/nv/evaluator_maps.h"

namespace arbiter::state {

/// An EvalCoord or an EvalPoint, whose u and v are grid indices. A display list stores its bytes.
struct EvaluatorPoint {
  GLuint dimension = 1; ///< 1 or 2
  bool onGrid = false;
  GLdouble u = 0, v = 0; ///< can hold any float and any GLint
};

/// The maps that a primitive's points are evaluated with. They are fetched at its Begin, because
/// the host cannot be queried after that.
struct Evaluation {
  struct Map {
    GLuint attribute = 0; ///< the number in NV_vertex_program
    EvaluatorMap map;
  };
  struct Dimension {
    /// The enabled maps that are not replaced by others; the position's map is last. Empty if the
    /// position has none, because nothing is evaluated then.
    std::vector<Map> maps;
    std::array<GLfloat, 4> gridDomain = {0, 1, 0, 1};
    std::array<GLint, 2> gridSegments = {1, 1};
    bool makesNormal = false; ///< true if AUTO_NORMAL replaces a map of the normal
  };
  std::array<Dimension, 2> dimensions; ///< for curves, and for surfaces
  /// The values that become current again after each point, if the host has the primitive.
  std::array<Vec4, 16> current{};
};

} // namespace arbiter::state
