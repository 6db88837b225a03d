#include "state/programs/nv/evaluator_maps.h"

#include <algorithm>

#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/programs/nv/nv_state.h"

namespace arbiter::state {

namespace {

/// The Bernstein polynomials of one order at t in [0,1], by de Casteljau's recurrence, and their
/// derivatives.
struct Weights {
  std::vector<GLfloat> values{1.0f};
  std::vector<GLfloat> slopes{0.0f};
};

Weights weightsOf(GLint order, GLfloat t) {
  Weights weights;
  for (GLint degree = 1; degree < order; ++degree) {
    const std::vector<GLfloat> lower = weights.values;
    weights.values.assign(std::size_t(degree) + 1, 0.0f);
    weights.slopes.assign(std::size_t(degree) + 1, 0.0f);
    for (std::size_t i = 0; i < lower.size(); ++i) {
      weights.values[i] += (1.0f - t) * lower[i];
      weights.values[i + 1] += t * lower[i];
      weights.slopes[i] -= GLfloat(degree) * lower[i];
      weights.slopes[i + 1] += GLfloat(degree) * lower[i];
    }
  }
  return weights;
}

void add(Vec4 &to, GLfloat factor, const Vec4 &what) {
  for (std::size_t c = 0; c < 4; ++c)
    to[c] += factor * what[c];
}

} // namespace

MapPoint evaluate(const EvaluatorMap &map, GLfloat u, GLfloat v) {
  const GLfloat width = map.domain[1] - map.domain[0], height = map.domain[3] - map.domain[2];
  const Weights across = weightsOf(map.order[0], (u - map.domain[0]) / width);
  const Weights along = weightsOf(map.order[1], (v - map.domain[2]) / height);
  MapPoint point;
  for (std::size_t i = 0; i < across.values.size(); ++i)
    for (std::size_t j = 0; j < along.values.size(); ++j) {
      const Vec4 &control = map.points[i * along.values.size() + j];
      add(point.value, across.values[i] * along.values[j], control);
      add(point.alongU, across.slopes[i] * along.values[j] / width, control);
      add(point.alongV, across.values[i] * along.slopes[j] / height, control);
    }
  return point;
}

void defineMap(ProgramContext &context, const MapDefinition &definition) {
  if (definition.error != GL_NO_ERROR)
    return raise(context, definition.error, "Map: target, domain, stride or order");
  GLint unit = GL_TEXTURE0;
  context.host->GetIntegerv(GL_ACTIVE_TEXTURE, &unit);
  if (unit != GL_TEXTURE0)
    return raise(context, GL_INVALID_OPERATION, "Map: the active texture unit is not 0");
  NvState &nv = *context.nv;
  if (!nv.maps)
    nv.maps = std::make_unique<std::array<EvaluatorMap, kEvaluatorMaps>>();
  (*nv.maps)[evaluatorMapOf(definition.target)] = definition.map;
}

void enableMap(ProgramContext &context, GLenum target, bool enabled) {
  const std::uint32_t bit = 1u << evaluatorMapOf(target);
  std::uint32_t &maps = context.nv->enabledMaps;
  maps = enabled ? maps | bit : maps & ~bit;
}

const EvaluatorMap &evaluatorMap(const ProgramContext &context, GLuint map) {
  static const EvaluatorMap s_undefined;
  return context.nv->maps ? (*context.nv->maps)[map] : s_undefined;
}

} // namespace arbiter::state
