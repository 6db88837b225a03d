#include <glm/geometric.hpp>

#include "scene/mesh/shapes.h"

namespace arbiter::scene {

namespace {

/// About how many vertices a shape has, before any is made.
double verticesOf(const ShapeSpec &spec) {
  const double parts = spec.argument("parts") + 1, count = spec.argument("count");
  switch (spec.shape.value) {
  case Shape::Quad:
    return 4;
  case Shape::Cube:
    return 24;
  case Shape::Billboards:
    return 4 * count;
  case Shape::Shells:
    return count * verticesOf(spec.of.front());
  case Shape::Volume:
    return 6 * verticesOf(spec.of.front());
  default:
    return parts * parts;
  }
}

Mesh makeShape(const ShapeSpec &spec);

Mesh makeAtHome(const ShapeSpec &spec) {
  const auto number = [&](const char *name) { return float(spec.argument(name)); };
  const int parts = int(spec.argument("parts")), count = int(spec.argument("count"));
  switch (spec.shape.value) {
  case Shape::Quad:
    return makeGrid(1);
  case Shape::Grid:
    return makeGrid(parts);
  case Shape::Plane:
    return makePlane(parts);
  case Shape::Cube:
    return makeCube();
  case Shape::Sphere:
    return makeSphere(parts);
  case Shape::Torus:
    return makeTorus(parts, number("radius"), number("tube"));
  case Shape::Cylinder:
    return makeCylinder(parts, number("radius"));
  case Shape::Knot:
    return makeKnot(parts, number("tube"));
  case Shape::Billboards:
    return makeBillboards(count, std::uint32_t(spec.argument("seed")));
  case Shape::Shells:
    return makeShells(makeShape(spec.of.front()), count);
  case Shape::Volume:
    return makeVolume(makeShape(spec.of.front()));
  }
  return {};
}

Mesh makeShape(const ShapeSpec &spec) {
  Mesh mesh = makeAtHome(spec);
  const glm::vec3 place(spec.at[0].value, spec.at[1].value, spec.at[2].value);
  const auto scale = float(spec.scale.value);
  if (scale != 1 || place != glm::vec3(0.0f))
    for (MeshVertex &vertex : mesh.vertices)
      vertex.position = vertex.position * scale + place;
  return mesh;
}

} // namespace

glm::vec3 MeshVertex::binormal() const {
  return glm::cross(normal, glm::vec3(tangent)) * tangent.w;
}

Result<Mesh, MeshError> buildMesh(const std::vector<ShapeSpec> &shapes) {
  if (shapes.empty())
    return makeGrid(1);
  double vertices = 0;
  Mesh whole;
  for (const ShapeSpec &spec : shapes) {
    vertices += verticesOf(spec);
    if (vertices > kMaxVertices)
      return MeshError{spec.shape.span, "the mesh has more than 2097152 vertices"};
    const Mesh mesh = makeShape(spec);
    for (const std::uint32_t index : mesh.indices)
      whole.indices.push_back(index + std::uint32_t(whole.vertices.size()));
    whole.vertices.insert(whole.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  }
  return whole;
}

glm::vec4 coordinateOf(const MeshVertex &vertex, const CoordinateSpec &spec) {
  switch (spec.source.value) {
  case Coordinate::St:
    return {vertex.st.x + float(spec.offset[0].value), vertex.st.y + float(spec.offset[1].value),
            0.0f, 1.0f};
  case Coordinate::Normal:
    return {vertex.normal, 1.0f};
  case Coordinate::Tangent:
    return vertex.tangent;
  case Coordinate::Binormal:
    return {vertex.binormal(), 1.0f};
  case Coordinate::Position:
    return {vertex.position, 1.0f};
  case Coordinate::Extra:
    return vertex.extra;
  }
  return {};
}

} // namespace arbiter::scene
