#include "state/primitives/joined.h"

#include "swrast/setup/assembly.h"

namespace arbiter::state {

using swrast::PolygonMode;
using swrast::Topology;

std::optional<Joining> joiningOf(const swrast::RasterState &state, GLenum mode, bool fromList) {
  const bool filled = state.front == PolygonMode::Fill && state.back == PolygonMode::Fill;
  switch (mode) {
  case GL_LINE_STRIP:
  case GL_LINE_LOOP:
    if (state.lineStippleFactor != 0)
      return std::nullopt;
    return Joining{Topology::Lines, state.provokingIsFirst};
  case GL_TRIANGLE_STRIP:
  case GL_TRIANGLE_FAN:
    // These triangles are indexed with their last vertex last, so only that one may provoke.
    if (!filled || (state.flatShade && state.provokingIsFirst))
      return std::nullopt;
    return Joining{Topology::Triangles, false};
  case GL_QUAD_STRIP:
    if (!fromList || !filled || (state.flatShade && state.quadsProvokingIsFirst))
      return std::nullopt;
    return Joining{Topology::Triangles, false};
  case GL_POLYGON:
    // The provoking vertex of a polygon is its first, which begins all of its triangles.
    if (!filled)
      return std::nullopt;
    return Joining{Topology::Triangles, true};
  default:
    return std::nullopt;
  }
}

void appendIndices(std::vector<std::uint32_t> &indices, GLenum mode, std::uint32_t first,
                   std::uint32_t count) {
  const auto topology = Topology(mode);
  const std::uint32_t lines = swrast::lineCount(topology, count);
  for (std::uint32_t i = 0; i < lines; ++i) {
    const swrast::LineEnds line = swrast::lineAt(topology, count, i, false);
    indices.insert(indices.end(), {first + line.end[0], first + line.end[1]});
  }
  const std::uint32_t triangles = swrast::triangleCount(topology, count);
  for (std::uint32_t i = 0; i < triangles; ++i) {
    // Quad strips are joined in lists only, where the two triangles of a quad have the other order.
    const swrast::TriangleCorners triangle = swrast::triangleAt(topology, count, i, false, true);
    const std::uint32_t *const corner = triangle.corner;
    indices.insert(indices.end(), {first + corner[0], first + corner[1], first + corner[2]});
  }
}

void makeIndices(std::vector<std::uint32_t> &indices, GLenum mode,
                 std::span<const std::uint32_t> starts, std::uint32_t end) {
  indices.clear();
  std::uint32_t first = 0;
  for (const std::uint32_t start : starts) {
    appendIndices(indices, mode, first, start - first);
    first = start;
  }
  appendIndices(indices, mode, first, end - first);
}

} // namespace arbiter::state
