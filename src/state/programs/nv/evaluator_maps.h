#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

#include "state/objects/target.h"

/// The 32 evaluator maps of NV_vertex_program (table 5.1): MAP1_VERTEX_ATTRIBn_4_NV and
/// MAP2_VERTEX_ATTRIBn_4_NV. A mask has a bit for each enabled map: bit n for the former, 16 + n
/// for the latter.
namespace arbiter::state {

struct ProgramContext;

inline constexpr GLuint kEvaluatorMaps = 32;

/// Returns the bit number of a map; kEvaluatorMaps or more for any other name.
[[nodiscard]] constexpr GLuint evaluatorMapOf(GLenum target) {
  return target - GL_MAP1_VERTEX_ATTRIB0_4_NV;
}
[[nodiscard]] constexpr bool isEvaluatorMap(GLenum target) {
  return evaluatorMapOf(target) < kEvaluatorMaps;
}

/// A Bezier curve or surface of four components.
struct EvaluatorMap {
  std::array<GLint, 2> order = {1, 1};          ///< in u and in v; 1 in v for a curve
  std::array<GLfloat, 4> domain = {0, 1, 0, 1}; ///< u1, u2, v1, v2
  std::vector<Vec4> points = {{0, 0, 0, 1}};    ///< order[0] rows of order[1] points
};

/// A point of a map, with its derivatives along u and, for a surface, v.
struct MapPoint {
  Vec4 value{};
  Vec4 alongU{};
  Vec4 alongV{};
};
[[nodiscard]] MapPoint evaluate(const EvaluatorMap &map, GLfloat u, GLfloat v);

/// The arguments of Map1 or Map2 with a copy of the points, or their error.
struct MapDefinition {
  GLenum target = 0;
  GLenum error = GL_NO_ERROR;
  EvaluatorMap map;
};

/// Executes Map1 and Map2.
/// \error the definition's error; INVALID_OPERATION if the active texture unit is not 0
void defineMap(ProgramContext &context, const MapDefinition &definition);
/// Executes Enable and Disable of a map.
void enableMap(ProgramContext &context, GLenum target, bool enabled);

/// Returns a map; one that was never defined is constant (0,0,0,1).
[[nodiscard]] const EvaluatorMap &evaluatorMap(const ProgramContext &context, GLuint map);

} // namespace arbiter::state
