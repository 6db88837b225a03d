#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "apps/scene/document.h"
#include "apps/scene/mesh/obj.h"
#include "apps/scene/mesh/shapes.h"

namespace arbiter::scene {

namespace {

/// Estimates a shape's vertex count before any is made; 0 for a file's shape.
double verticesOf(const ShapeSpec &spec) {
  const double parts = spec.argument("parts") + 1, count = spec.argument("count");
  switch (spec.shape.value) {
  case Shape::File:
    return 0;
  case Shape::Quad:
    return 4;
  case Shape::Cube:
    return 24;
  case Shape::Billboards:
    return 4 * count;
  case Shape::Shells:
    return count * verticesOf(spec.of.front());
  case Shape::Fins:
    return 6 * parts * verticesOf(spec.of.front());
  case Shape::Volume:
    return 6 * verticesOf(spec.of.front());
  default:
    return parts * parts;
  }
}

MeshError tooMany(const ShapeSpec &spec) {
  return {spec.shape.span, "the mesh has more than 2097152 vertices"};
}

/// Scales the mesh into [-1,1] and centers it.
void fit(Mesh &mesh) {
  glm::vec3 low(mesh.vertices.front().position), high(low);
  for (const MeshVertex &vertex : mesh.vertices) {
    low = glm::min(low, vertex.position);
    high = glm::max(high, vertex.position);
  }
  const glm::vec3 half = high * 0.5f - low * 0.5f, middle = low * 0.5f + high * 0.5f;
  const float most = std::max({half.x, half.y, half.z, 1e-30f});
  for (MeshVertex &vertex : mesh.vertices)
    vertex.position = (vertex.position - middle) / most;
}

Result<Mesh, MeshError> readFile(const ShapeSpec &spec, const std::string &folder) {
  const std::string path =
      spec.file.text.starts_with('/') ? spec.file.text : folder + spec.file.text;
  const auto text = readText(path);
  if (!text)
    return MeshError{spec.shape.span, text.error().message};
  const auto faces = readObj(text.value());
  if (!faces)
    return MeshError{spec.shape.span, path + ": " + faces.error().message};
  Mesh mesh = meshOf(faces.value());
  if (spec.argument("fit") != 0)
    fit(mesh);
  return mesh;
}

class Maker {
public:
  explicit Maker(const std::string &folder) : m_folder(folder) {}

  Result<Mesh, MeshError> make(const ShapeSpec &spec) const {
    Result<Mesh, MeshError> made = makeAtHome(spec);
    if (!made)
      return made;
    const glm::vec3 place(spec.at[0].value, spec.at[1].value, spec.at[2].value);
    const auto scale = float(spec.scale.value);
    if (scale != 1 || place != glm::vec3(0.0f))
      for (MeshVertex &vertex : made.value().vertices)
        vertex.position = vertex.position * scale + place;
    return made;
  }

private:
  [[nodiscard]] Result<Mesh, MeshError> makeAtHome(const ShapeSpec &spec) const {
    if (spec.shape.value == Shape::File)
      return readFile(spec, m_folder);
    return spec.of.empty() ? makeAlone(spec) : makeOf(spec);
  }

  /// Makes a shape from another. Only now is the vertex count of a file known.
  [[nodiscard]] Result<Mesh, MeshError> makeOf(const ShapeSpec &spec) const {
    auto inner = make(spec.of.front());
    if (!inner)
      return inner;
    const auto count = int(spec.argument("count")), parts = int(spec.argument("parts"));
    const auto vertices = double(inner.value().vertices.size()),
               corners = double(inner.value().indices.size());
    const bool shells = spec.shape.value == Shape::Shells, fins = spec.shape.value == Shape::Fins;
    if ((shells ? count * vertices : fins ? 2 * (parts + 1) * corners : corners) > kMaxVertices)
      return tooMany(spec);
    return shells ? makeShells(inner.value(), count)
           : fins ? makeFins(inner.value(), parts)
                  : makeVolume(inner.value());
  }

  static Mesh makeAlone(const ShapeSpec &spec) {
    const auto number = [&](const char *name) { return float(spec.argument(name)); };
    const int parts = int(spec.argument("parts"));
    switch (spec.shape.value) {
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
      return makeBillboards(int(spec.argument("count")), std::uint32_t(spec.argument("seed")));
    default:
      return makeGrid(1);
    }
  }

  const std::string &m_folder;
};

} // namespace

glm::vec3 MeshVertex::binormal() const {
  return glm::cross(normal, glm::vec3(tangent)) * tangent.w;
}

Result<Mesh, MeshError> buildMesh(const std::vector<ShapeSpec> &shapes, const std::string &folder) {
  if (shapes.empty())
    return makeGrid(1);
  double vertices = 0;
  for (const ShapeSpec &spec : shapes)
    if ((vertices += verticesOf(spec)) > kMaxVertices)
      return tooMany(spec);
  Mesh whole;
  for (const ShapeSpec &spec : shapes) {
    auto mesh = Maker(folder).make(spec);
    if (!mesh)
      return mesh;
    if (double(whole.vertices.size() + mesh.value().vertices.size()) > kMaxVertices)
      return tooMany(spec);
    for (const std::uint32_t index : mesh.value().indices)
      whole.indices.push_back(index + std::uint32_t(whole.vertices.size()));
    whole.vertices.insert(whole.vertices.end(), mesh.value().vertices.begin(),
                          mesh.value().vertices.end());
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
