#include "apps/scene/mesh/mesh.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <map>

namespace arbiter::scene {
namespace {

Mesh meshOf(const std::string &words) {
  const Panel panel = parsePanel("#@ mesh " + words + "\n");
  EXPECT_TRUE(panel.diagnostics.empty()) << words;
  auto mesh = buildMesh(panel.mesh, "");
  EXPECT_TRUE(mesh) << words;
  return mesh ? std::move(mesh).value() : Mesh{};
}

class Shapes : public testing::TestWithParam<const char *> {};

TEST_P(Shapes, HaveFramesOfUnitLengthAndFacesThatLookOutwards) {
  const Mesh mesh = meshOf(GetParam());
  ASSERT_FALSE(mesh.indices.empty());
  for (const MeshVertex &vertex : mesh.vertices) {
    EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-4);
    EXPECT_NEAR(glm::dot(vertex.normal, glm::vec3(vertex.tangent)), 0, 2e-3);
  }
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto corner = [&](std::size_t j) { return mesh.vertices.at(mesh.indices[i + j]); };
    const glm::vec3 along = corner(1).position - corner(0).position;
    const glm::vec3 face = glm::cross(along, corner(2).position - corner(0).position);
    ASSERT_GT(glm::dot(face, corner(0).normal + corner(1).normal + corner(2).normal), 0)
        << "triangle " << i / 3;
  }
}

TEST_P(Shapes, TangentsPointWhereSGrows) {
  const Mesh mesh = meshOf(GetParam());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const MeshVertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                     &c = mesh.vertices[mesh.indices[i + 2]];
    const glm::vec3 p = b.position - a.position, q = c.position - a.position;
    const glm::vec2 u = b.st - a.st, v = c.st - a.st;
    const glm::vec3 towards = (p * v.y - q * u.y) * (u.x * v.y - v.x * u.y);
    if (glm::length(towards) > 1e-9f) {
      ASSERT_GT(glm::dot(glm::normalize(towards), glm::vec3(a.tangent)), 0.5f)
          << "triangle " << i / 3;
    }
    const glm::vec3 up = (q * u.x - p * v.x) * (u.x * v.y - v.x * u.y);
    if (glm::length(up) > 1e-9f) {
      ASSERT_GT(glm::dot(glm::normalize(up), a.binormal()), 0.5f) << "triangle " << i / 3;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Shapes,
                         testing::Values("quad", "grid parts 5", "plane parts 3", "cube",
                                         "sphere parts 24", "torus parts 24", "cylinder parts 16",
                                         "knot parts 40"));

TEST(Mesh, PlaceAndScaleAreInThatOrder) {
  const Mesh mesh = meshOf("quad at 1 2 3 scale 0.5 and quad");
  ASSERT_EQ(mesh.vertices.size(), 8u);
  EXPECT_EQ(mesh.vertices[0].position, glm::vec3(0.5f, 1.5f, 3));
  EXPECT_EQ(mesh.vertices[4].position, glm::vec3(-1, -1, 0));
  EXPECT_EQ(mesh.indices[6], 4u);
}

TEST(Mesh, ShellsCountFromInsideOut) {
  const Mesh mesh = meshOf("shells count 3 of quad");
  ASSERT_EQ(mesh.vertices.size(), 12u);
  EXPECT_EQ(mesh.vertices[0].extra.x, 0);
  EXPECT_EQ(mesh.vertices[4].extra.x, 0.5f);
  EXPECT_EQ(mesh.vertices[11].extra.x, 1);
}

/// A cube has 12 edges, and a diagonal in each of its six faces.
TEST(Mesh, FinsStandInEachEdgeOnce) {
  const Mesh mesh = meshOf("fins parts 3 of cube");
  ASSERT_EQ(mesh.vertices.size(), 18u * 2 * 4);
  EXPECT_EQ(mesh.indices.size(), 18u * 3 * 6);
  EXPECT_EQ(mesh.vertices[0].extra, glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(mesh.vertices[7].extra, glm::vec4(1, 1, 0, 1));
  EXPECT_EQ(mesh.vertices[0].position, mesh.vertices[6].position) << "before they are raised";
}

/// In a closed volume two triangles share every edge and run along it in opposite directions. That
/// includes the sphere's seam and its poles, so that the volume has no hole however its faces move.
TEST(Mesh, AVolumeIsClosed) {
  for (const char *words : {"volume of cube", "volume of sphere parts 12",
                            "volume of torus parts 12", "volume of knot parts 16"}) {
    const Mesh mesh = meshOf(words);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
      for (std::size_t j = 0; j < 3; ++j)
        ++edges[{mesh.indices[i + j], mesh.indices[i + (j + 1) % 3]}];
    int open = 0;
    for (const auto &[ends, count] : edges)
      if (const auto other = edges.find({ends.second, ends.first});
          other == edges.end() || other->second != count)
        ++open;
    // The two ends of a quad are not edges of a face: they meet those of other quads in one corner.
    for (const auto &[ends, count] : edges) {
      const auto &a = mesh.vertices[ends.first].position, &b = mesh.vertices[ends.second].position;
      open -= glm::distance(a, b) < 1e-3f && !edges.contains({ends.second, ends.first});
    }
    EXPECT_EQ(open, 0) << words;
  }
}

TEST(Mesh, TooManyVerticesAreAnErrorBeforeTheyAreMade) {
  const Panel panel = parsePanel("#@ mesh shells count 64 of sphere parts 512\n");
  const auto mesh = buildMesh(panel.mesh, "");
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().span, panel.mesh[0].shape.span);
}

TEST(Mesh, CoordinatesAreWhatIsAsked) {
  const Panel panel =
      parsePanel("#@ mesh cylinder\n#@ texcoord 0 = st 0.5 0.25, texcoord 1 = extra\n");
  const MeshVertex vertex = buildMesh(panel.mesh, "").value().vertices.front();
  EXPECT_EQ(coordinateOf(vertex, panel.coordinates[0]), glm::vec4(0.5f, 0.25f, 0, 1));
  EXPECT_EQ(coordinateOf(vertex, panel.coordinates[1]), glm::vec4(1, 0, 0, 1))
      << "the lower bone's";
}

} // namespace
} // namespace arbiter::scene
