#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <GL/gl.h>

#include "swrast/draw_input.h"

/// Joins consecutive primitives whose vertices depend on each other (strips, fans, loops,
/// polygons). They are drawn as one, as the triangles or lines that they consist of, by indices.
/// Some applications draw each face as a polygon.
namespace arbiter::state {

struct Joining {
  /// the primitives that the indices make: Triangles or Lines
  swrast::Topology topology = swrast::Topology::Triangles;
  bool provokingIsFirst = false; ///< true if the first vertex of each provokes
};

/// Returns how to join primitives of `mode` in the current state, or nothing if joining would be
/// visible. These cases are: unfilled polygons, whose sides differ from their
/// triangles'; stipples that run along a strip; a provoking vertex in the middle of a triangle; and
/// quad strips outside of lists, where clipping decides the order of their triangles.
[[nodiscard]] std::optional<Joining> joiningOf(const swrast::RasterState &state, GLenum mode,
                                               bool fromList = false);
/// Appends the indices of one primitive of `mode` with vertices [first, first + count).
void appendIndices(std::vector<std::uint32_t> &indices, GLenum mode, std::uint32_t first,
                   std::uint32_t count);
/// Fills `indices` for several primitives. The first begins at vertex 0, the others at `starts`,
/// and the last ends before `end`.
void makeIndices(std::vector<std::uint32_t> &indices, GLenum mode,
                 std::span<const std::uint32_t> starts, std::uint32_t end);

} // namespace arbiter::state
