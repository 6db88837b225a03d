#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "scene.h"

namespace arbiter::raster_test {
namespace {

using swrast::Topology;

/// The host's pixels and ours, by rows and by blocks of every size.
void expectSame(const Scene &scene, const std::string &what) {
  const Counts host = drawByHost(scene);
  ASSERT_FALSE(host.empty()) << "no OSMesa context";
  for (const int lanes : {0, 4, 8, 16}) {
    const Difference difference = compare(scene, host, drawByUs(scene, lanes));
    ASSERT_EQ(difference.pixels, 0)
        << what << ", lanes " << lanes << ": of " << difference.covered << " covered, "
        << difference.text << "size " << scene.width << "x" << scene.height;
  }
}

class Coverage : public testing::Test {
protected:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(m_random);
  }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_random); }
  /// On pixel centres and corners as often as anywhere.
  double place(double low, double high) {
    const double at = uniform(low, high);
    switch (integer(0, 3)) {
    case 0:
      return std::floor(at) + 0.5;
    case 1:
      return std::floor(at);
    case 2:
      return std::floor(at * 256) / 256;
    default:
      return at;
    }
  }
  Scene scene(Topology topology) {
    Scene result;
    result.width = integer(0, 2) ? 64 : integer(1, 100);
    result.height = integer(0, 2) ? 64 : integer(1, 100);
    result.topology = topology;
    return result;
  }
  std::mt19937 m_random{7};
};

TEST_F(Coverage, Triangles) {
  for (int round = 0; round < 400; ++round) {
    Scene s = scene(Topology::Triangles);
    for (int i = 0; i < 3 * integer(1, 4); ++i)
      s.add(place(-5, s.width + 5), place(-5, s.height + 5));
    expectSame(s, "round " + std::to_string(round));
  }
}

TEST_F(Coverage, SmallTriangles) {
  for (int round = 0; round < 100; ++round) {
    Scene s = scene(Topology::Triangles);
    for (int i = 0; i < 400; ++i) {
      const double x = uniform(0, s.width), y = uniform(0, s.height);
      for (int k = 0; k < 3; ++k)
        s.add(place(x - 3, x + 3), place(y - 3, y + 3));
    }
    expectSame(s, "round " + std::to_string(round));
  }
}

TEST_F(Coverage, EveryPolygonalTopology) {
  for (const Topology topology : {Topology::TriangleStrip, Topology::TriangleFan, Topology::Quads,
                                  Topology::QuadStrip, Topology::Polygon})
    for (int round = 0; round < 100; ++round) {
      Scene s = scene(topology);
      for (int i = 0; i < integer(1, 9); ++i)
        s.add(place(0, s.width), place(0, s.height));
      expectSame(s,
                 "topology " + std::to_string(int(topology)) + " round " + std::to_string(round));
    }
}

TEST_F(Coverage, Perspective) {
  for (int round = 0; round < 300; ++round) {
    Scene s = scene(Topology::Triangles);
    for (int i = 0; i < 3; ++i)
      s.add(place(-5, s.width + 5), place(-5, s.height + 5), uniform(0.1, 10), uniform(-1, 1));
    expectSame(s, "round " + std::to_string(round));
  }
}

TEST_F(Coverage, CulledTriangles) {
  for (int round = 0; round < 100; ++round) {
    Scene s = scene(Topology::Triangles);
    s.state.cullBack = round & 1;
    s.state.cullFront = round & 2;
    s.state.frontIsClockwise = round & 4;
    for (int i = 0; i < 6; ++i)
      s.add(place(0, s.width), place(0, s.height));
    expectSame(s, "round " + std::to_string(round));
  }
}

TEST_F(Coverage, ClippedTriangles) {
  for (int round = 0; round < 400; ++round) {
    Scene s = scene(Topology::Triangles);
    for (int i = 0; i < 3; ++i)
      s.vertices.push_back({float(uniform(-1.5, 1.5)), float(uniform(-1.5, 1.5)),
                            float(uniform(-1.5, 1.5)), float(uniform(-0.5, 1.5))});
    expectSame(s, "round " + std::to_string(round));
  }
}

TEST_F(Coverage, HugeTriangles) {
  for (int round = 0; round < 200; ++round) {
    Scene s = scene(Topology::Triangles);
    const double scale = std::pow(10.0, uniform(0, 8));
    for (int i = 0; i < 3; ++i)
      s.add(uniform(-scale, scale), uniform(-scale, scale));
    expectSame(s, "round " + std::to_string(round) + " scale " + std::to_string(scale));
  }
}

} // namespace
} // namespace arbiter::raster_test
