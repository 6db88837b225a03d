#pragma once
#include <array>
#include <vector>

#include "apps/scene/document.h"
#include "apps/scene/mesh/mesh.h"
#include "apps/tools/debug/pixel/drawer.h"
#include "apps/tools/debug/trace/record.h"

/// Traces a document's vertex program for the corners of the triangle that is visible in a pixel.
namespace arbiter::tools::debug {

struct TracedVertex {
  std::uint32_t index = 0; ///< index in the mesh
  Vec4 clip = {};          ///< position in clip space
  Trace trace;
};
using TracedTriangle = std::array<TracedVertex, 3>;

/// A vertex program, its text, and the document and pass that it is drawn in.
struct VertexStage {
  const fp::ir::Program &program;
  const std::string &text;
  const scene::Document &document;
  const scene::Pass &pass;
  double seconds = 0;
};

/// Returns a vertex's attributes from the document's mesh, in the order of Program::attributes.
[[nodiscard]] std::vector<Vec4> attributesOf(const VertexStage &stage,
                                             const scene::MeshVertex &vertex);

/// Traces the triangle that contains the pixel's center and passes culling and the depth test.
/// Without a depth test it is the last one drawn. Skips triangles that reach behind the eye. GL
/// state is read by drawing with \p drawer, or asked for if only vertex programs can read it. Fails
/// if there is no such triangle, or if the drawer or the mesh fails.
[[nodiscard]] Result<TracedTriangle, DebugError> traceTriangle(const VertexStage &stage,
                                                               Drawer &drawer, int x, int y);

} // namespace arbiter::tools::debug
