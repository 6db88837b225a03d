// Makes images whose texels are directions or displacements instead of colors.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "apps/scene/texture/generators.h"

namespace arbiter::scene {

namespace {

/// The value of no displacement: the maximum, 65535, is odd and cannot be halved exactly
constexpr int kNone = 32768;

template <typename Offset> Image displacements(int width, int height, Offset offset) {
  Image image(width, height, 16);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::vec2 moved = offset(image.coordinate(x, y) - 0.5f);
      std::uint16_t *texel =
          &image.texels[4 * (std::size_t(y) * std::size_t(width) + std::size_t(x))];
      for (int i = 0; i < 2; ++i)
        texel[i] =
            std::uint16_t(std::lround(std::clamp(moved[i], -0.5f, 0.4999f) * 65535.0f) + kNone);
      texel[2] = 0;
      texel[3] = 65535;
    }
  return image;
}

/// Returns the direction of a cube map face at s and t in [-1,1] (GL, 3.8.6).
glm::vec3 directionOf(int face, float s, float t) {
  switch (face) {
  case 0:
    return {1, -t, -s};
  case 1:
    return {-1, -t, s};
  case 2:
    return {s, 1, t};
  case 3:
    return {s, -1, -t};
  case 4:
    return {s, -t, 1};
  default:
    return {-s, -t, -1};
  }
}

template <typename Color> std::vector<Image> cube(int side, Color color) {
  std::vector<Image> faces(6, Image(side, side));
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const glm::vec2 at = faces[0].coordinate(x, y) * 2.0f - 1.0f;
        const glm::vec3 direction = glm::normalize(directionOf(face, at.x, at.y));
        faces[std::size_t(face)].set(x, y, glm::vec4(color(direction), 1.0f));
      }
  return faces;
}

} // namespace

Image makeTwirl(const TextureSource &source, int width, int height) {
  const auto radius = float(source.argument("radius")), turn = float(source.argument("turn"));
  return displacements(width, height, [&](glm::vec2 from) {
    const float inside = std::max(0.0f, 1.0f - glm::length(from) / radius);
    const float angle = turn * inside * inside;
    const float c = std::cos(angle), s = std::sin(angle);
    return glm::vec2(c * from.x - s * from.y, s * from.x + c * from.y) - from;
  });
}

Image makeRipple(const TextureSource &source, int width, int height) {
  const auto rings = float(source.argument("rings")), depth = float(source.argument("depth"));
  return displacements(width, height, [&](glm::vec2 from) {
    const float distance = glm::length(from);
    const float wave = std::sin(2 * std::numbers::pi_v<float> * rings * 2.0f * distance);
    return distance > 0 ? from / distance * (depth * wave) : glm::vec2(0.0f);
  });
}

Image makeNormals(const Image &heights, float strength) {
  Image image(heights.width, heights.height);
  const auto height = [&](int x, int y) {
    return heights.at((x + heights.width) % heights.width, (y + heights.height) % heights.height).r;
  };
  // Slopes are relative to texture coordinates: a larger image of the same heights has the same
  // normals.
  const float alongS = strength * float(heights.width) / 64.0f;
  const float alongT = strength * float(heights.height) / 64.0f;
  for (int y = 0; y < heights.height; ++y)
    for (int x = 0; x < heights.width; ++x) {
      const float ds = alongS * (height(x + 1, y) - height(x - 1, y));
      const float dt = alongT * (height(x, y + 1) - height(x, y - 1));
      const glm::vec3 normal = glm::normalize(glm::vec3(-ds, -dt, 1.0f));
      image.set(x, y, glm::vec4(normal * 0.5f + 0.5f, height(x, y)));
    }
  return image;
}

std::vector<Image> makeNormalize(int side) {
  return cube(side, [](const glm::vec3 &direction) { return direction * 0.5f + 0.5f; });
}

std::vector<Image> makeSky(const TextureSource &source, int side) {
  const glm::vec3 sun = glm::normalize(glm::vec3(0.5f, float(source.argument("sun")), 0.6f));
  return cube(side, [&](const glm::vec3 &direction) {
    const float up = direction.y;
    const glm::vec3 sky = glm::mix(glm::vec3(0.85f, 0.80f, 0.72f), glm::vec3(0.20f, 0.42f, 0.80f),
                                   std::sqrt(glm::clamp(up, 0.0f, 1.0f)));
    const glm::vec3 ground = glm::mix(glm::vec3(0.35f, 0.30f, 0.24f),
                                      glm::vec3(0.14f, 0.11f, 0.08f), glm::clamp(-up, 0.0f, 1.0f));
    const float glow = glm::clamp(glm::dot(direction, sun), 0.0f, 1.0f);
    return glm::mix(ground, sky, glm::smoothstep(-0.05f, 0.05f, up)) +
           glm::vec3(1.0f, 0.9f, 0.6f) * std::pow(glow, 64.0f);
  });
}

} // namespace arbiter::scene
