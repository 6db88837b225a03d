#include "state/host_draw/evaluators/evaluation.h"

#include <algorithm>

#include "host/host_table.h"
#include "state/host_draw/draw_context.h"
#include "state/host_draw/evaluators/nv_attributes.h"
#include "state/programs/nv/nv_state.h"

namespace arbiter::state {

namespace {

constexpr GLuint kPositionAttribute = 0, kNormalAttribute = 2;

/// The conventional maps (OpenGL 2.1, table 5.1), except that of colour indices. If two maps of an
/// attribute are enabled, the first in the table counts.
struct Conventional {
  GLenum target; ///< the target of MAP1; that of MAP2 has the same offset as for VERTEX_3
  GLuint attribute;
  std::size_t components;
};
constexpr Conventional kConventional[] = {{GL_MAP1_COLOR_4, 3, 4},
                                          {GL_MAP1_NORMAL, kNormalAttribute, 3},
                                          {GL_MAP1_TEXTURE_COORD_4, 8, 4},
                                          {GL_MAP1_TEXTURE_COORD_3, 8, 3},
                                          {GL_MAP1_TEXTURE_COORD_2, 8, 2},
                                          {GL_MAP1_TEXTURE_COORD_1, 8, 1},
                                          {GL_MAP1_VERTEX_4, kPositionAttribute, 4},
                                          {GL_MAP1_VERTEX_3, kPositionAttribute, 3}};

/// Returns a conventional map of the host's, extended to four components.
EvaluatorMap hostsMap(const host::HostTable &host, GLenum target, int dimension,
                      std::size_t components) {
  EvaluatorMap map;
  host.GetMapiv(target, GL_ORDER, map.order.data());
  host.GetMapfv(target, GL_DOMAIN, map.domain.data());
  if (dimension == 0)
    map.order[1] = 1;
  const auto points = std::size_t(map.order[0]) * std::size_t(map.order[1]);
  std::vector<GLfloat> numbers(points * components);
  host.GetMapfv(target, GL_COEFF, numbers.data());
  map.points.assign(points, {0, 0, 0, 1});
  for (std::size_t i = 0; i < points; ++i)
    std::copy_n(numbers.begin() + std::ptrdiff_t(i * components), components,
                map.points[i].begin());
  return map;
}

void takeGrid(const host::HostTable &host, int dimension, Evaluation::Dimension &taken) {
  host.GetFloatv(dimension == 0 ? GL_MAP1_GRID_DOMAIN : GL_MAP2_GRID_DOMAIN,
                 taken.gridDomain.data());
  host.GetIntegerv(dimension == 0 ? GL_MAP1_GRID_SEGMENTS : GL_MAP2_GRID_SEGMENTS,
                   taken.gridSegments.data());
}

bool has(const Evaluation::Dimension &dimension, GLuint attribute) {
  return std::any_of(dimension.maps.begin(), dimension.maps.end(),
                     [&](const Evaluation::Map &map) { return map.attribute == attribute; });
}

/// Collects the enabled maps of one dimension. Maps of NV_vertex_program replace conventional ones.
Evaluation::Dimension take(DrawContext &context, int number) {
  const host::HostTable &host = *context.host;
  Evaluation::Dimension dimension;
  const GLuint first = number == 0 ? 0 : 16;
  for (GLuint i = 0; i < NvState::kAttributes; ++i)
    if ((context.nv->enabledMaps >> (first + i) & 1u) != 0)
      dimension.maps.push_back({i, evaluatorMap(context, first + i)});
  const GLenum higher = number == 0 ? 0 : GL_MAP2_VERTEX_3 - GL_MAP1_VERTEX_3;
  for (const Conventional &row : kConventional)
    if (!has(dimension, row.attribute) && host.IsEnabled(row.target + higher))
      dimension.maps.push_back(
          {row.attribute, hostsMap(host, row.target + higher, number, row.components)});
  std::stable_partition(
      dimension.maps.begin(), dimension.maps.end(),
      [](const Evaluation::Map &map) { return map.attribute != kPositionAttribute; });
  if (!has(dimension, kPositionAttribute))
    return {};
  dimension.makesNormal = number == 1 && host.IsEnabled(GL_AUTO_NORMAL);
  takeGrid(host, number, dimension);
  return dimension;
}

/// Returns (dq/du) x (dq/dv) with q = (x/w, y/w, z/w). It is not normalized: programs do that
/// (5.1).
Vec4 normalOf(const MapPoint &position) {
  const auto slope = [&](const Vec4 &along, std::size_t c) {
    const Vec4 &p = position.value;
    return (along[c] * p[3] - p[c] * along[3]) / (p[3] * p[3]);
  };
  Vec4 normal = {0, 0, 0, 1};
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
    normal[c] = slope(position.alongU, d) * slope(position.alongV, e) -
                slope(position.alongU, e) * slope(position.alongV, d);
  }
  return normal;
}

GLfloat gridPoint(GLdouble number, GLfloat from, GLfloat to, GLint segments) {
  return number == segments ? to : from + GLfloat(number) * ((to - from) / GLfloat(segments));
}

/// Passes a point to the host, whose maps are the only ones in use.
void pass(const host::HostTable &host, const EvaluatorPoint &point) {
  const bool curve = point.dimension == 1;
  if (point.onGrid && curve)
    host.EvalPoint1(GLint(point.u));
  else if (point.onGrid)
    host.EvalPoint2(GLint(point.u), GLint(point.v));
  else if (curve)
    host.EvalCoord1d(point.u);
  else
    host.EvalCoord2d(point.u, point.v);
}

} // namespace

bool mayEvaluate(const DrawContext &context) {
  return context.nv && context.nv->enabledMaps != 0 && context.row(Target::Vertex).enabled;
}

void beginEvaluation(DrawContext &context) {
  if (context.insideBeginEnd)
    return;
  if (context.listMode != 0)
    return context.list->record(context, {.kind = Command::Kind::PrepareEvaluation});
  prepareEvaluation(context);
}

void prepareEvaluation(DrawContext &context) {
  if (!context.nv || context.insideBeginEnd)
    return;
  context.nv->evaluation = nullptr;
  if (!mayEvaluate(context))
    return;
  auto evaluation = std::make_unique<Evaluation>();
  for (int i = 0; i < 2; ++i)
    evaluation->dimensions[std::size_t(i)] = take(context, i);
  for (const Evaluation::Dimension &dimension : evaluation->dimensions) {
    for (const Evaluation::Map &map : dimension.maps)
      if (map.attribute != kPositionAttribute)
        evaluation->current[map.attribute] = currentNvAttribute(context, map.attribute);
    if (dimension.makesNormal)
      evaluation->current[kNormalAttribute] = currentNvAttribute(context, kNormalAttribute);
  }
  context.nv->evaluation = std::move(evaluation);
}

void evaluatePoint(DrawContext &context, const EvaluatorPoint &point) {
  const Evaluation *const evaluation = context.nv ? context.nv->evaluation.get() : nullptr;
  if (!evaluation || !context.insideBeginEnd)
    return pass(*context.host, point);
  const Evaluation::Dimension &dimension = evaluation->dimensions[point.dimension - 1];
  auto u = GLfloat(point.u), v = GLfloat(point.v);
  if (point.onGrid) {
    const auto &[u1, u2, v1, v2] = dimension.gridDomain;
    u = gridPoint(point.u, u1, u2, dimension.gridSegments[0]);
    v = gridPoint(point.v, v1, v2, dimension.gridSegments[1]);
  }
  // Evaluation must not change current values.
  std::array<Vec4, NvState::kAttributes> before = evaluation->current;
  std::uint32_t touched = 0;
  const auto set = [&](GLuint attribute, const Vec4 &value) {
    if (context.recorder && attribute != kPositionAttribute)
      before[attribute] = currentNvAttribute(context, attribute);
    touched |= 1u << attribute;
    setNvAttribute(context, attribute, value);
  };
  for (const Evaluation::Map &map : dimension.maps) {
    if (map.attribute == kNormalAttribute && dimension.makesNormal)
      continue;
    const MapPoint evaluated = evaluate(map.map, u, v);
    if (map.attribute == kPositionAttribute && dimension.makesNormal)
      set(kNormalAttribute, normalOf(evaluated));
    set(map.attribute, evaluated.value);
  }
  for (GLuint i = 1; i < NvState::kAttributes; ++i)
    if ((touched >> i & 1u) != 0)
      setNvAttribute(context, i, before[i]);
}

} // namespace arbiter::state
