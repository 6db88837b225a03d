#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "apps/scene/texture/generators.h"
#include "apps/scene/texture/noise.h"

namespace arbiter::scene {

namespace {

constexpr float kHorizon = 0.36f;

glm::vec3 skyAt(glm::vec2 at) {
  const float up = glm::clamp((at.y - kHorizon) / (1 - kHorizon), 0.0f, 1.0f);
  glm::vec3 color =
      glm::mix(glm::vec3(0.98f, 0.80f, 0.58f), glm::vec3(0.18f, 0.38f, 0.72f), std::sqrt(up));
  const float fromSun = glm::length(at - glm::vec2(0.7f, 0.72f));
  color += 0.4f * std::exp(-8.0f * fromSun) * glm::vec3(1.0f, 0.8f, 0.4f);
  color = glm::mix(glm::vec3(1.0f, 0.97f, 0.82f), color, glm::smoothstep(0.078f, 0.084f, fromSun));
  const float height = glm::smoothstep(0.42f, 0.62f, at.y);
  if (height == 0.0f) // no cloud, whatever the noise
    return color;
  const float cloud = fractalNoise(at * glm::vec2(4.0f, 11.0f), 5, 0, 11);
  const float cover = glm::smoothstep(0.52f, 0.78f, cloud) * height;
  return glm::mix(color, glm::vec3(0.96f), 0.85f * cover);
}

/// Returns a checkered ground up to the horizon. It fades into haze where its fields are smaller
/// than a texel.
glm::vec3 groundAt(glm::vec2 at) {
  const float distance = 0.06f / (kHorizon + 0.002f - at.y);
  const glm::vec2 field = glm::floor(glm::vec2((at.x - 0.5f) * distance * 36.0f, distance * 8.0f));
  const bool dark = (int(field.x) + int(field.y)) % 2 != 0;
  const glm::vec3 color = dark ? glm::vec3(0.15f, 0.24f, 0.18f) : glm::vec3(0.82f, 0.76f, 0.60f);
  return glm::mix(color, glm::vec3(0.60f, 0.58f, 0.52f),
                  glm::smoothstep(kHorizon - 0.08f, kHorizon, at.y));
}

/// The heights of the mountains at an s.
struct Skyline {
  explicit Skyline(float s)
      : far(kHorizon + 0.17f * fractalNoise({s * 4.0f, 3.5f}, 5, 0, 21) * (1.1f - s)),
        near(kHorizon + 0.13f * fractalNoise({s * 6.0f, 8.5f}, 5, 0, 22) * (0.2f + s)) {}
  float far, near;
};

glm::vec3 colorAt(glm::vec2 at, const Skyline &skyline) {
  if (at.y < kHorizon)
    return groundAt(at);
  if (at.y < skyline.near)
    return glm::vec3(0.15f, 0.27f, 0.16f) * (0.75f + 0.5f * fractalNoise(at * 60.0f, 3, 0, 23));
  if (at.y < skyline.far)
    return glm::mix(glm::vec3(0.62f, 0.58f, 0.60f), glm::vec3(0.36f, 0.40f, 0.55f),
                    glm::smoothstep(kHorizon, skyline.far, at.y));
  return skyAt(at);
}

} // namespace

Image makeLandscape(int width, int height) {
  Image image(width, height);
  std::vector<Skyline> skylines; // one for each column, as noise takes most of the picture's time
  skylines.reserve(std::size_t(width));
  for (int x = 0; x < width; ++x)
    skylines.emplace_back(image.coordinate(x, 0).x);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.set(x, y, glm::vec4(colorAt(image.coordinate(x, y), skylines[std::size_t(x)]), 1.0f));
  return image;
}

} // namespace arbiter::scene
