#pragma once
#include <array>
#include <vector>

#include "scene/document.h"
#include "scene/mesh/mesh.h"
#include "tools/debug/pixel/drawer.h"
#include "tools/debug/trace/record.h"

/// What a document's vertex program does for the corners of the triangle that is seen in a pixel.
namespace arbiter::tools::debug {

struct TracedVertex {
  std::uint32_t index = 0; ///< in the mesh
  Vec4 clip = {};          ///< its position
  Trace trace;
};
using TracedTriangle = std::array<TracedVertex, 3>;

/// A vertex program, its text, and what it is drawn with.
struct VertexStage {
  const fp::ir::Program &program;
  const std::string &text;
  const scene::Document &document;
  const scene::Pass &pass;
  double seconds = 0;
};

/// The attributes of a vertex in the order of Program::attributes, as the document's mesh gives
/// them.
[[nodiscard]] std::vector<Vec4> attributesOf(const VertexStage &stage,
                                             const scene::MeshVertex &vertex);

/// The triangle whose corners lie around the pixel's centre and that the depth test and culling
/// leave (the last one drawn where there is no depth test). Triangles that reach behind the eye are
/// not found. Rows of GL's state are drawn by \p drawer as fragment programs read them; those that
/// only vertex programs have it is asked for. Errors: no such triangle; the drawer's; the mesh's.
[[nodiscard]] Result<TracedTriangle, DebugError> traceTriangle(const VertexStage &stage,
                                                               Drawer &drawer, int x, int y);

} // namespace arbiter::tools::debug
