#pragma once
#include <array>
#include <vector>

#include "state/programs/nv/evaluator_maps.h"

namespace arbiter::state {

/// EvalCoord, or EvalPoint, whose u and v are numbers of the grid. A display list keeps its bytes.
struct EvaluatorPoint {
  GLuint dimension = 1; ///< 1 or 2
  bool onGrid = false;
  GLdouble u = 0, v = 0; ///< which hold any float and any GLint
};

/// What a primitive's points are evaluated by: taken at its Begin, as the host may not be asked
/// behind it.
struct Evaluation {
  struct Map {
    GLuint attribute = 0; ///< NV_vertex_program's number
    EvaluatorMap map;
  };
  struct Dimension {
    /// The enabled ones, without those that another takes the place of; that of the position is the
    /// last one. None where the position has none, as nothing is evaluated then.
    std::vector<Map> maps;
    std::array<GLfloat, 4> gridDomain = {0, 1, 0, 1};
    std::array<GLint, 2> gridSegments = {1, 1};
    bool makesNormal = false; ///< AUTO_NORMAL, in place of a map of the normal
  };
  std::array<Dimension, 2> dimensions; ///< of curves, and of surfaces
  /// What becomes current again after each point, where the host has the primitive.
  std::array<Vec4, 16> current{};
};

} // namespace arbiter::state
