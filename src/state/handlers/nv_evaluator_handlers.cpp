// Evaluators (OpenGL 2.1, 5.1) with the maps of NV_vertex_program (5.1): commands that name such a
// map, and evaluation after one was named. All else is the host's
// (state/handlers/entry/straight.h).
#include <algorithm>
#include <cstdint>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/host_draw/evaluators/evaluation.h"
#include "state/host_draw/evaluators/nv_attributes.h"
#include "state/lists/list_compiler.h"
#include "state/lists/mesh_commands.h"
#include "state/programs/nv/nv_state.h"

namespace arbiter::state {

namespace {

/// Map's arguments for one dimension.
template <typename T> struct Side {
  T from, to;
  GLint stride, order;
};

/// Returns Map's error. Each dimension has half of the map names, and the host sets the greatest
/// order.
template <typename T>
GLenum mapError(Context &context, GLenum target, const Side<T> &u, const Side<T> *v) {
  constexpr GLint kComponents = 4;
  if (!isEvaluatorMap(target) || (evaluatorMapOf(target) < kEvaluatorMaps / 2) != (v == nullptr))
    return GL_INVALID_ENUM;
  GLint most = 1;
  context.host->GetIntegerv(GL_MAX_EVAL_ORDER, &most);
  const auto isRight = [&](const Side<T> &side) {
    return side.from != side.to && side.stride >= kComponents && side.order >= 1 &&
           side.order <= most;
  };
  return isRight(u) && (!v || isRight(*v)) ? GL_NO_ERROR : GL_INVALID_VALUE;
}

/// Copies the points at once, even for a list (5.4).
template <typename T>
MapDefinition definitionOf(Context &context, GLenum target, const Side<T> &u, const Side<T> *v,
                           const T *points) {
  MapDefinition definition{.target = target, .error = mapError(context, target, u, v)};
  if (definition.error != GL_NO_ERROR || !points)
    return definition;
  EvaluatorMap &map = definition.map;
  map.order[0] = u.order;
  map.domain = {GLfloat(u.from), GLfloat(u.to), 0, 1};
  if (v) {
    map.order[1] = v->order;
    map.domain[2] = GLfloat(v->from);
    map.domain[3] = GLfloat(v->to);
  }
  map.points.clear();
  for (GLint i = 0; i < map.order[0]; ++i)
    for (GLint j = 0; j < map.order[1]; ++j) {
      const T *const p =
          points + std::ptrdiff_t(i) * u.stride + std::ptrdiff_t(j) * (v ? v->stride : 0);
      map.points.push_back({GLfloat(p[0]), GLfloat(p[1]), GLfloat(p[2]), GLfloat(p[3])});
    }
  return definition;
}

template <typename T>
void define(Context &context, GLenum target, const Side<T> &u, const Side<T> *v, const T *points) {
  if (!outsideBeginEnd(context, "Map between Begin and End"))
    return;
  const MapDefinition definition = definitionOf(context, target, u, v, points);
  context.mapsNamed = true;
  if (!context.listMode)
    return defineMap(context, definition);
  const EvaluatorMap &map = definition.map;
  Command command{.kind = Command::Kind::DefineMap,
                  .target = target,
                  .name = GLuint(map.order[0]),
                  .object = GLuint(map.order[1]),
                  .format = definition.error};
  command.values.push_back(map.domain);
  command.values.insert(command.values.end(), map.points.begin(), map.points.end());
  listCompiler(context).record(context, std::move(command));
}

template <typename T> void getMap(Context &context, GLenum target, GLenum query, T *v) {
  if (!outsideBeginEnd(context, "GetMap between Begin and End"))
    return;
  const GLuint number = evaluatorMapOf(target);
  if (number >= kEvaluatorMaps || (query != GL_COEFF && query != GL_ORDER && query != GL_DOMAIN))
    return raise(context, GL_INVALID_ENUM, "GetMap: target or query");
  if (!v)
    return;
  const std::size_t dimensions = number < kEvaluatorMaps / 2 ? 1 : 2;
  const EvaluatorMap &map = evaluatorMap(context, number);
  if (query == GL_ORDER)
    std::transform(map.order.begin(), map.order.begin() + dimensions, v,
                   [](GLint order) { return T(order); });
  else if (query == GL_DOMAIN)
    std::transform(map.domain.begin(), map.domain.begin() + 2 * dimensions, v, rounded<T>);
  else
    for (const Vec4 &point : map.points)
      v = std::transform(point.begin(), point.end(), v, rounded<T>);
}

void evaluate(Context &context, const EvaluatorPoint &point) {
  if (context.listMode == 0 || context.insideBeginEnd)
    return evaluatePoint(context, point);
  Command command{.kind = Command::Kind::EvalPoint};
  command.bytes.assign(reinterpret_cast<const char *>(&point), sizeof point);
  listCompiler(context).record(context, std::move(command));
}

} // namespace

namespace handlers {

#define MAPS(letter, T)                                                                            \
  void Map1##letter(Context &context, GLenum target, T u1, T u2, GLint stride, GLint order,        \
                    const T *points) {                                                             \
    define<T>(context, target, {u1, u2, stride, order}, nullptr, points);                          \
  }                                                                                                \
  void Map2##letter(Context &context, GLenum target, T u1, T u2, GLint ustride, GLint uorder,      \
                    T v1, T v2, GLint vstride, GLint vorder, const T *points) {                    \
    const Side<T> v{v1, v2, vstride, vorder};                                                      \
    define<T>(context, target, {u1, u2, ustride, uorder}, &v, points);                             \
  }                                                                                                \
  void EvalCoord1##letter(Context &context, T u) { evaluate(context, {1, false, u, 0}); }          \
  void EvalCoord2##letter(Context &context, T u, T v) { evaluate(context, {2, false, u, v}); }     \
  void EvalCoord1##letter##v(Context &context, const T *u) {                                       \
    evaluate(context, {1, false, u[0], 0});                                                        \
  }                                                                                                \
  void EvalCoord2##letter##v(Context &context, const T *u) {                                       \
    evaluate(context, {2, false, u[0], u[1]});                                                     \
  }
MAPS(f, GLfloat)
MAPS(d, GLdouble)
#undef MAPS

void GetMapfv(Context &context, GLenum target, GLenum query, GLfloat *v) {
  getMap(context, target, query, v);
}

void GetMapdv(Context &context, GLenum target, GLenum query, GLdouble *v) {
  getMap(context, target, query, v);
}

void GetMapiv(Context &context, GLenum target, GLenum query, GLint *v) {
  getMap(context, target, query, v);
}

void EvalPoint1(Context &context, GLint i) { evaluate(context, {1, true, GLdouble(i), 0}); }

void EvalPoint2(Context &context, GLint i, GLint j) {
  evaluate(context, {2, true, GLdouble(i), GLdouble(j)});
}

void EvalMesh1(Context &context, GLenum mode, GLint i1, GLint i2) {
  issueEvalMesh(context, {1, mode, i1, i2, 0, 0});
}

void EvalMesh2(Context &context, GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2) {
  issueEvalMesh(context, {2, mode, i1, i2, j1, j2});
}

} // namespace handlers
} // namespace arbiter::state
