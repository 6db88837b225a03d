#pragma once
#include "apps/scene/mesh/mesh.h"

/// Makes the shapes, one function for each; build.cpp selects one.
namespace arbiter::scene {

[[nodiscard]] Mesh makeGrid(int parts);
[[nodiscard]] Mesh makePlane(int parts);
[[nodiscard]] Mesh makeCube();
[[nodiscard]] Mesh makeSphere(int parts);
[[nodiscard]] Mesh makeTorus(int parts, float radius, float tube);
[[nodiscard]] Mesh makeCylinder(int parts, float radius);
[[nodiscard]] Mesh makeKnot(int parts, float tube);
[[nodiscard]] Mesh makeBillboards(int count, std::uint32_t seed);

/// Makes copies of a mesh behind one another, with extra.x from 0 to 1.
[[nodiscard]] Mesh makeShells(const Mesh &mesh, int count);
/// Makes a strip of \p parts quads in each edge. It has no area until a vertex program raises it:
/// extra.x goes from 0 to 1 along it, and extra.y is the edge's end, 0 or 1.
[[nodiscard]] Mesh makeFins(const Mesh &mesh, int parts);
/// Makes a mesh for shadow volumes. Each face has vertices and a normal of its own. Each edge that
/// two faces share has a quad, without area at first. A vertex program that moves the vertices of
/// faces turned away from the light makes a shadow volume of it, which is closed if the mesh is.
[[nodiscard]] Mesh makeVolume(const Mesh &mesh);

} // namespace arbiter::scene
