#include "apps/scene/mesh/obj.h"
#include "apps/scene/testing/rounds.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <random>

namespace arbiter::scene {
namespace {

using testing::HasSubstr;

/// A square with texture coordinates and a triangle without.
constexpr const char *kSquare = "# a comment\nmtllib ../../etc/passwd\no thing\n"
                                "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 4\n"
                                "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl x\n"
                                "f 1/1 2/2 3/3 4/4\nf -1 1 4\nl 1 2\n";

Mesh meshOfText(const std::string &text) {
  const auto faces = readObj(text);
  EXPECT_TRUE(faces) << text;
  return faces ? meshOf(faces.value()) : Mesh();
}

TEST(Obj, FacesAreTrianglesWithFrames) {
  const Mesh mesh = meshOfText(kSquare);
  EXPECT_EQ(mesh.indices.size(), 9u);
  ASSERT_EQ(mesh.vertices.size(), 7u) << "a corner with texture coordinates is not one without";
  for (std::size_t i = 0; i < 4; ++i) {
    const MeshVertex &vertex = mesh.vertices[i];
    EXPECT_EQ(vertex.st, glm::vec2(vertex.position) / 2.0f);
    EXPECT_GT(glm::dot(glm::vec3(vertex.tangent), glm::vec3(1, 0, 0)), 0.4f);
    EXPECT_EQ(vertex.tangent.w, 1);
    EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-5);
    EXPECT_NEAR(glm::dot(vertex.normal, glm::vec3(vertex.tangent)), 0, 1e-5);
  }
  EXPECT_EQ(mesh.vertices[1].normal, glm::vec3(0, 0, 1)) << "of the square alone";
  EXPECT_GT(mesh.vertices[0].normal.x, 0) << "between the square's and the triangle's";
  EXPECT_EQ(mesh.vertices[4].st, glm::vec2(0));
}

TEST(Obj, NormalsOfTheFileHold) {
  const Mesh mesh = meshOfText("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 3 4\nf 1//1 2//1 3\n");
  EXPECT_EQ(mesh.vertices[0].normal, glm::vec3(0, 0.6f, 0.8f));
  EXPECT_EQ(mesh.vertices[2].normal, glm::vec3(0, 0, 1));
}

TEST(Obj, MirroredTextureCoordinatesTurnTheBinormal) {
  const Mesh mesh = meshOfText("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt -1 0\nvt 0 1\n"
                               "f 1/1 2/2 3/3\n");
  EXPECT_EQ(mesh.vertices[0].tangent, glm::vec4(-1, 0, 0, -1));
  EXPECT_EQ(mesh.vertices[0].binormal(), glm::vec3(0, 1, 0)) << "the direction of t";
}

float areaOf(const std::vector<glm::vec3> &corners) {
  float whole = 0;
  for (const auto &[a, b, c] : cutPolygon(corners)) {
    const float area = glm::cross(corners[b] - corners[a], corners[c] - corners[a]).x / 2;
    EXPECT_GE(area, 0) << "a triangle turns the other way";
    whole += area;
  }
  return whole;
}

/// If triangles overlap or stick out, their total area differs from the polygon's.
TEST(Obj, PolygonsNeedNotBeConvex) {
  const auto flat = [](std::vector<glm::vec2> corners) {
    std::vector<glm::vec3> all;
    for (const glm::vec2 &corner : corners)
      all.emplace_back(7, corner);
    return all;
  };
  EXPECT_FLOAT_EQ(areaOf(flat({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}})), 10);
  EXPECT_FLOAT_EQ(areaOf(flat({{2, 1}, {0, 4}, {0, 0}, {4, 0}, {4, 4}})), 10);
  EXPECT_FLOAT_EQ(areaOf(flat({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 3}, {0, 3}})),
                  7);
  EXPECT_EQ(cutPolygon(flat({{0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}})).size(), 3u);
  EXPECT_TRUE(cutPolygon({glm::vec3(0), glm::vec3(1)}).empty());
}

struct Wrong {
  std::string text, said;
};

TEST(Obj, WhatIsWrongIsSaid) {
  std::string wide = "v 0 0 0\nf";
  for (int i = 0; i < 257; ++i)
    wide += " 1";
  for (const Wrong &wrong :
       {Wrong{"", "no face"}, Wrong{"v 1 2 3\n", "no face"},
        Wrong{"v 0 0 0\nf 1 1 2\n", "face 1 names vertex 2 of 1"},
        Wrong{"v 0 0 0\nf 1 1 -2\n", "names vertex -2 of 1"},
        Wrong{"v 0 0 0\nf 1 1 -2147483648\n", "names vertex -2147483648"},
        Wrong{"v 0 0 0\nf 1/1 1 1\n", "names texture coordinate 1 of 0"},
        Wrong{"v 0 0 0\nf 1//9 1 1\n", "names normal 9 of 0"},
        Wrong{"v 0 0 0\nf 0 1 1\n", "a corner of face 1 names no vertex"},
        Wrong{"v 0 0 0\nf 1 1\n", "face 1 has 2 corners"}, Wrong{wide, "has 257 corners"},
        Wrong{"v 1e300 0 0\nf 1 1 1\n", "v 1 is not finite"}}) {
    const auto faces = readObj(wrong.text);
    ASSERT_FALSE(faces) << wrong.text;
    EXPECT_THAT(faces.error().message, HasSubstr(wrong.said));
  }
}

/// Any bytes yield an error, or a mesh whose indices and numbers are valid.
TEST(Obj, ChangedBytesEndSoon) {
  std::string text = kSquare;
  std::minstd_rand random(5);
  constexpr std::string_view kBytes = "vtnf/ 0123456789-.e\n\r\\\0#"
                                      "t 9/9/9\n";
  for (int i = 0; i < hostileRounds(3000); ++i) {
    if (i % 60 == 0)
      text = kSquare;
    const std::size_t at = random() % text.size();
    if (random() % 3 == 0)
      text.erase(at, 1 + random() % 4);
    else
      text.insert(at, 1, kBytes[random() % kBytes.size()]);
    const auto faces = readObj(text);
    if (!faces)
      continue;
    const Mesh mesh = meshOf(faces.value());
    for (const std::uint32_t index : mesh.indices)
      ASSERT_LT(index, mesh.vertices.size()) << text;
    for (const MeshVertex &vertex : mesh.vertices)
      ASSERT_TRUE(std::isfinite(glm::length(vertex.normal)) &&
                  std::isfinite(glm::length(vertex.tangent)))
          << text;
  }
  (void)readObj("v 0 0 0\nt x 2000000000/2000000000/2000000000\nf 1 1 1\n");
}

class ObjFile : public testing::Test {
protected:
  void SetUp() override {
    m_folder = testing::TempDir() + "arbiter-obj-" + std::to_string(::getpid()) + "/";
    std::filesystem::create_directory(m_folder);
    std::ofstream(m_folder + "a.obj") << "v 10 0 0\nv 14 0 0\nv 14 2 0\nv 10 2 0\nf 1 2 3 4\n";
  }
  void TearDown() override { std::filesystem::remove_all(m_folder); }

  Result<Mesh, MeshError> build(const std::string &words) const {
    const Panel panel = parsePanel("#@ mesh " + words + "\n");
    EXPECT_TRUE(panel.diagnostics.empty()) << words;
    return buildMesh(panel.mesh, m_folder);
  }

  std::string m_folder;
};

TEST_F(ObjFile, IsAShapeLikeOthers) {
  const auto plain = build("a.obj");
  ASSERT_TRUE(plain) << plain.error().message;
  EXPECT_EQ(plain.value().vertices[0].position, glm::vec3(10, 0, 0));
  const auto fitted = build("a.obj fit 1 at 0 5 0 scale 2 and quad");
  ASSERT_TRUE(fitted);
  EXPECT_EQ(fitted.value().vertices.size(), 8u);
  EXPECT_EQ(fitted.value().vertices[0].position, glm::vec3(-2, 4, 0));
  EXPECT_EQ(build("shells count 3 of a.obj").value().vertices.size(), 12u);
}

TEST_F(ObjFile, ThatIsWrongIsAnErrorAtItsName) {
  EXPECT_THAT(build("none.obj").error().message, HasSubstr(m_folder + "none.obj"));
  EXPECT_EQ(build("none.obj").error().span, (fp::Span{8, 16}));
  std::ofstream(m_folder + "b.obj") << "v 0 0 0\nf 1 2 3\n";
  EXPECT_THAT(build("quad and b.obj").error().message, HasSubstr("b.obj: face 1 names vertex 2"));
  std::ofstream many(m_folder + "c.obj");
  for (int i = 0; i < 40000; ++i)
    many << "v " << i << " 0 0\nv 0 " << i << " 1\nv 0 1 " << i << "\nf -1 -2 -3\n";
  many.close();
  EXPECT_THAT(build("shells count 64 of c.obj").error().message, HasSubstr("2097152"));
}

} // namespace
} // namespace arbiter::scene
