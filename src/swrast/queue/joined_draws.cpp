#include "swrast/queue/joined_draws.h"

#include <algorithm>

#include "swrast/setup/assembly.h"
#include "swrast/setup/viewport.h"

namespace arbiter::swrast {
namespace {

/// Finds what is visible of filled triangles without user clip planes. The tests are those of
/// windowVertex()'s outcodes.
Sight sightOf(const Vertices &vertices, bool depthClamp) {
  bool inside = true;
  std::uint32_t beyond = kOutSides | kOutNear | kOutFar;
  for (std::uint32_t i = 0; i < vertices.count; ++i) {
    const float x = vertices.position[0][i], y = vertices.position[1][i];
    const float z = vertices.position[2][i], w = vertices.position[3][i];
    const float sum = x + y + z + w;
    const bool isFinite = sum - sum == 0 && w > 0;
    const bool withinDepth = depthClamp || (z >= -w && z <= w);
    inside = inside && isFinite && x >= -w && x <= w && y >= -w && y <= w && withinDepth;
    std::uint32_t out = 0;
    out |= x < -w ? kOutLeft : 0u;
    out |= x > w ? kOutRight : 0u;
    out |= y < -w ? kOutBottom : 0u;
    out |= y > w ? kOutTop : 0u;
    if (!depthClamp) {
      out |= z < -w ? kOutNear : 0u;
      out |= z > w ? kOutFar : 0u;
    }
    beyond &= out;
  }
  return inside ? Sight::Whole : beyond != 0 ? Sight::None : Sight::Part;
}

/// True for filled triangles without user clip planes. Unfilled polygons need their edges, and
/// clipping makes other triangles.
bool isPlain(const GivenDraw &given) {
  const RasterState &state = given.state;
  const Vertices &vertices = given.vertices;
  return isPolygonal(given.topology) && state.front == PolygonMode::Fill &&
         state.back == PolygonMode::Fill && state.coverage == abi::Coverage::Whole &&
         vertices.count <= JoinedDraws::kMaxOfOne && given.count <= JoinedDraws::kMaxOfOne &&
         !vertices.make &&
         std::all_of(vertices.position, vertices.position + 4,
                     [](const float *component) { return component != nullptr; }) &&
         std::none_of(std::begin(vertices.clipDistance), std::end(vertices.clipDistance),
                      [](const float *plane) { return plane != nullptr; });
}

/// Calls `visit(own, given)` for each input array that the shading may read.
template <typename Visit>
void forInputs(const Shading &shading, Vertices &own, const Vertices &given, Visit visit) {
  for (std::uint32_t i = 0; i < shading.inputCount; ++i)
    for (std::uint32_t c = 0; c < 4; ++c)
      if ((shading.inputComponents[i] >> c & 1u) != 0) {
        visit(own.inputs[i][c], given.inputs[i][c]);
        visit(own.backInputs[i][c], given.backInputs[i][c]);
      }
}

} // namespace

Sight sightOf(const GivenDraw &given) {
  return isPlain(given) ? sightOf(given.vertices, given.state.depthClamp) : Sight::Unknown;
}

void JoinedDraws::begin(const GivenDraw &given) {
  if (m_indices.empty())
    m_indices.resize(std::size_t(kProvokingAt) + kMaxTriangles);
  std::size_t arrays = 4;
  forInputs(given.shading, m_vertices, given.vertices,
            [&](const float *, const float *from) { arrays += from ? 1u : 0u; });
  if (m_values.size() < arrays * kMaxVertices)
    m_values.resize(arrays * kMaxVertices);
  m_vertices = {};
  float *next = m_values.data();
  const auto take = [&](const float *&own, const float *from) {
    if (!from)
      return;
    own = next;
    next += kMaxVertices;
  };
  for (int c = 0; c < 4; ++c)
    take(m_vertices.position[c], given.vertices.position[c]);
  forInputs(given.shading, m_vertices, given.vertices, take);
}

bool JoinedDraws::hasSameArrays(const GivenDraw &given) {
  bool isSame = true;
  forInputs(given.shading, m_vertices, given.vertices, [&](const float *own, const float *from) {
    isSame = isSame && (own != nullptr) == (from != nullptr);
  });
  return isSame;
}

bool JoinedDraws::hasRoom(const GivenDraw &given, std::uint32_t triangles) const {
  return m_vertices.count + given.vertices.count <= kMaxVertices &&
         m_triangles + triangles <= kMaxTriangles;
}

void JoinedDraws::copyVertices(const GivenDraw &given) {
  const std::uint32_t count = given.vertices.count;
  float *next = m_values.data() + m_vertices.count;
  const auto copy = [&](const float *, const float *from) {
    if (!from)
      return;
    std::copy_n(from, count, next);
    next += kMaxVertices;
  };
  for (const float *const component : given.vertices.position)
    copy(nullptr, component);
  forInputs(given.shading, m_vertices, given.vertices, copy);
  m_vertices.count += count;
}

void JoinedDraws::addTriangles(const GivenDraw &given, std::uint32_t triangles) {
  const RasterState &state = given.state;
  const bool provokingIsFirst = provokesFirst(state, given.topology);
  const bool otherDiagonal = cutsOtherwise(state, given.topology, false);
  const std::uint32_t base = m_vertices.count, end = given.vertices.count;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const TriangleCorners corners =
        triangleAt(given.topology, given.count, i, provokingIsFirst, otherDiagonal);
    const auto vertexAt = [&](std::uint32_t place) {
      return given.indices ? given.indices[place] : given.first + place;
    };
    const std::uint32_t a = vertexAt(corners.corner[0]), b = vertexAt(corners.corner[1]),
                        c = vertexAt(corners.corner[2]), p = vertexAt(corners.provoking);
    if (a >= end || b >= end || c >= end || p >= end)
      continue;
    std::uint32_t *const to = m_indices.data() + std::size_t(3) * m_triangles;
    to[0] = base + a;
    to[1] = base + b;
    to[2] = base + c;
    m_indices[kProvokingAt + m_triangles] = base + p;
    ++m_triangles;
  }
}

bool JoinedDraws::add(const GivenDraw &given) {
  const std::uint32_t triangles = triangleCount(given.topology, given.count);
  if (isEmpty())
    begin(given);
  else if (!hasSameArrays(given) || !hasRoom(given, triangles))
    return false;
  addTriangles(given, triangles);
  copyVertices(given);
  return true;
}

} // namespace arbiter::swrast
