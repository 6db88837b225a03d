#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <GL/gl.h>

#include "swrast/draw_input.h"

/// Primitives whose vertices depend on each other (strips, fans, loops, polygons) that follow one
/// another, drawn as one: as the triangles or lines that they are made of, by indices. Of some
/// applications each face is a polygon of its own.
namespace arbiter::state::software {

struct Joining {
  swrast::Topology topology = swrast::Topology::Triangles; ///< or Lines: what the indices are of
  bool provokingIsFirst = false;                           ///< of each of these
};

/// How primitives of `mode` are joined in the current state; nothing where that could be told from
/// each drawn alone: unfilled polygons, whose sides are not those of their triangles, stipples that
/// run along a strip, a provoking vertex that lies within the triangle, and quad strips but of a
/// list, as otherwise the draw's clipping decides about their triangles' order.
[[nodiscard]] std::optional<Joining> joiningOf(const swrast::RasterState &state, GLenum mode,
                                               bool fromList = false);
/// Appends to `indices` those of one primitive of `mode`: vertices [first, first + count).
void appendIndices(std::vector<std::uint32_t> &indices, GLenum mode, std::uint32_t first,
                   std::uint32_t count);
/// Fills `indices` for several: one begins at vertex 0, the others at `starts`, and the last ends
/// before `end`.
void makeIndices(std::vector<std::uint32_t> &indices, GLenum mode,
                 std::span<const std::uint32_t> starts, std::uint32_t end);

} // namespace arbiter::state::software
