#pragma once
#include "scene/mesh/mesh.h"

/// One function a shape; build.cpp chooses.
namespace arbiter::scene {

[[nodiscard]] Mesh makeGrid(int parts);
[[nodiscard]] Mesh makePlane(int parts);
[[nodiscard]] Mesh makeCube();
[[nodiscard]] Mesh makeSphere(int parts);
[[nodiscard]] Mesh makeTorus(int parts, float radius, float tube);
[[nodiscard]] Mesh makeCylinder(int parts, float radius);
[[nodiscard]] Mesh makeKnot(int parts, float tube);
[[nodiscard]] Mesh makeBillboards(int count, std::uint32_t seed);

/// Copies of a mesh behind one another, extra.x from 0 to 1.
[[nodiscard]] Mesh makeShells(const Mesh &mesh, int count);
/// A strip of quads in each edge, of as many quads as \p parts, without area until a vertex program
/// raises it: extra.x goes from 0 to 1 along it, extra.y is the edge's end, 0 or 1.
[[nodiscard]] Mesh makeFins(const Mesh &mesh, int parts);
/// Each face with vertices and a normal of its own, and a quad, without area for now, in each edge
/// that two faces share: a vertex program that moves the vertices of faces turned from the light
/// makes a shadow volume of it, closed if the mesh is.
[[nodiscard]] Mesh makeVolume(const Mesh &mesh);

} // namespace arbiter::scene
