#include "apps/scene/mesh/shapes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "apps/scene/texture/noise.h"

namespace arbiter::scene {

namespace {

constexpr float kTurn = 2 * std::numbers::pi_v<float>;

/// Makes two triangles for each cell of a grid over s and t in [0,1], except for triangles without
/// area.
template <typename At> Mesh surface(int across, int up, At at) {
  Mesh mesh;
  for (int y = 0; y <= up; ++y)
    for (int x = 0; x <= across; ++x) {
      const glm::vec2 st(float(x) / float(across), float(y) / float(up));
      MeshVertex vertex = at(st.x, st.y);
      vertex.st = st;
      mesh.vertices.push_back(vertex);
    }
  const auto add = [&](int a, int b, int c) {
    const auto &corners = mesh.vertices;
    const auto apart = [&](int i, int j) {
      return glm::distance(corners[std::size_t(i)].position, corners[std::size_t(j)].position) >
             1e-5f;
    };
    if (apart(a, b) && apart(b, c) && apart(c, a))
      mesh.indices.insert(mesh.indices.end(),
                          {std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)});
  };
  for (int y = 0; y < up; ++y)
    for (int x = 0; x < across; ++x) {
      const int a = y * (across + 1) + x, d = a + across + 1;
      add(a, a + 1, d + 1);
      add(a, d + 1, d);
    }
  return mesh;
}

MeshVertex vertexOf(const glm::vec3 &position, const glm::vec3 &normal, const glm::vec3 &tangent) {
  MeshVertex vertex;
  vertex.position = position;
  vertex.normal = normal;
  vertex.tangent = glm::vec4(tangent, 1.0f);
  return vertex;
}

/// Returns a point of the (2,3) torus knot's core at \p t in [0, 2 pi).
glm::vec3 knotCore(float t) {
  const float radius = 1.0f + 0.42f * std::cos(3.0f * t);
  return glm::vec3(radius * std::cos(2.0f * t), radius * std::sin(2.0f * t),
                   0.4f * std::sin(3.0f * t)) /
         1.6f;
}

} // namespace

Mesh makeGrid(int parts) {
  return surface(parts, parts, [](float s, float t) {
    return vertexOf({2 * s - 1, 2 * t - 1, 0}, {0, 0, 1}, {1, 0, 0});
  });
}

Mesh makePlane(int parts) {
  return surface(parts, parts, [](float s, float t) {
    return vertexOf({2 * s - 1, 0, 1 - 2 * t}, {0, 1, 0}, {1, 0, 0});
  });
}

Mesh makeCube() {
  // The normal and the direction of s of each face.
  static const glm::vec3 kFaces[6][2] = {{{1, 0, 0}, {0, 0, -1}}, {{-1, 0, 0}, {0, 0, 1}},
                                         {{0, 1, 0}, {1, 0, 0}},  {{0, -1, 0}, {1, 0, 0}},
                                         {{0, 0, 1}, {1, 0, 0}},  {{0, 0, -1}, {-1, 0, 0}}};
  Mesh mesh;
  for (const auto &face : kFaces) {
    const glm::vec3 &normal = face[0], &right = face[1];
    const glm::vec3 up = glm::cross(normal, right);
    const Mesh square = surface(1, 1, [&](float s, float t) {
      return vertexOf(normal + (2 * s - 1) * right + (2 * t - 1) * up, normal, right);
    });
    for (const std::uint32_t index : square.indices)
      mesh.indices.push_back(index + std::uint32_t(mesh.vertices.size()));
    mesh.vertices.insert(mesh.vertices.end(), square.vertices.begin(), square.vertices.end());
  }
  return mesh;
}

Mesh makeSphere(int parts) {
  // s goes once around from the back, t from the south pole to the north pole.
  return surface(parts, parts, [](float s, float t) {
    const float around = kTurn * s, up = kTurn / 2 * t;
    const glm::vec3 point(-std::sin(up) * std::sin(around), -std::cos(up),
                          -std::sin(up) * std::cos(around));
    return vertexOf(point, point, {-std::cos(around), 0, std::sin(around)});
  });
}

Mesh makeTorus(int parts, float radius, float tube) {
  return surface(parts, parts, [&](float s, float t) {
    const float a = kTurn * s, b = kTurn * t;
    const glm::vec3 out(std::sin(a), 0, std::cos(a));
    const glm::vec3 normal = std::cos(b) * out + glm::vec3(0, std::sin(b), 0);
    return vertexOf(radius * out + tube * normal, normal, {std::cos(a), 0, -std::sin(a)});
  });
}

Mesh makeCylinder(int parts, float radius) {
  return surface(parts, parts, [&](float s, float t) {
    const float a = kTurn * s, y = 2 * t - 1;
    const glm::vec3 out(std::sin(a), 0, std::cos(a));
    MeshVertex vertex =
        vertexOf(radius * out + glm::vec3(0, y, 0), out, {std::cos(a), 0, -std::sin(a)});
    const float at = std::fmin(std::fmax((y + 0.4f) / 0.8f, 0.0f), 1.0f);
    const float upper = at * at * (3 - 2 * at);
    vertex.extra = {1 - upper, upper, 0, 1};
    return vertex;
  });
}

Mesh makeKnot(int parts, float tube) {
  return surface(4 * parts, parts / 4, [&](float s, float t) {
    const float along = kTurn * s, around = kTurn * t;
    const glm::vec3 tangent = glm::normalize(knotCore(along + 0.001f) - knotCore(along - 0.001f));
    // This direction points away from the torus that the knot winds around, which is never along
    // the knot.
    const glm::vec3 away(std::cos(3 * along) * std::cos(2 * along),
                         std::cos(3 * along) * std::sin(2 * along), std::sin(3 * along));
    const glm::vec3 side = glm::normalize(glm::cross(tangent, away));
    const glm::vec3 normal = std::cos(around) * side + std::sin(around) * glm::cross(side, tangent);
    return vertexOf(knotCore(along) + tube * normal, normal, tangent);
  });
}

Mesh makeBillboards(int count, std::uint32_t seed) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const auto random = [&](int which) { return randomAt(i, which, seed); };
    const auto first = std::uint32_t(mesh.vertices.size());
    for (const glm::vec2 st : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
      MeshVertex &vertex = mesh.vertices.emplace_back();
      vertex.position = glm::vec3(random(0), random(1), random(2)) * 2.0f - 1.0f;
      vertex.st = st;
      vertex.extra = {2 * st.x - 1, 2 * st.y - 1, random(3), random(4)};
    }
    for (const std::uint32_t corner : {0, 1, 2, 0, 2, 3})
      mesh.indices.push_back(first + corner);
  }
  return mesh;
}

} // namespace arbiter::scene
