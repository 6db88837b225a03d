#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "apps/scene/texture/generators.h"
#include "apps/scene/texture/noise.h"

namespace arbiter::scene {

namespace {

glm::vec4 grey(float level) { return {level, level, level, 1.0f}; }

/// Makes an image from a function of the texture coordinate.
template <typename Color> Image paint(int width, int height, Color color) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.set(x, y, color(image.coordinate(x, y)));
  return image;
}

std::uint32_t seedOf(const TextureSource &source) { return std::uint32_t(source.argument("seed")); }

} // namespace

Image makeConstant(const TextureSource &source, int width, int height) {
  const auto get = [&](const char *name) { return float(source.argument(name)); };
  const glm::vec4 color(get("r"), get("g"), get("b"), get("a"));
  return paint(width, height, [&](glm::vec2) { return color; });
}

Image makeChecker(const TextureSource &source, int width, int height) {
  const int cells = int(source.argument("cells"));
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool light = (x * cells / width + y * cells / height) % 2 != 0;
      image.set(x, y, grey(float(source.argument(light ? "light" : "dark"))));
    }
  return image;
}

Image makeNoise(int width, int height) {
  Image image(width, height);
  std::uint32_t state = 2463534242u; // xorshift32: the sequence determines the picture
  for (std::uint16_t &texel : image.texels) {
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    texel = std::uint16_t(state >> 24);
  }
  return image;
}

Image makeClouds(const TextureSource &source, int width, int height) {
  const int scale = int(source.argument("scale")), octaves = int(source.argument("octaves"));
  return paint(width, height, [&](glm::vec2 at) {
    return grey(fractalNoise(at * float(scale), octaves, scale, seedOf(source)));
  });
}

Image makeGradient(const TextureSource &source, int width, int height) {
  const auto get = [&](const char *name) { return float(source.argument(name)); };
  const float low = get("low"), high = get("high"), power = get("power");
  const float steps = std::floor(get("steps"));
  return paint(width, height, [&](glm::vec2 at) {
    float s = std::pow(at.x, power);
    if (steps > 1)
      s = std::min(std::floor(s * steps), steps - 1) / (steps - 1);
    return grey(glm::mix(low, high, s));
  });
}

Image makeSpot(const TextureSource &source, int width, int height) {
  const auto radius = float(source.argument("radius")), soft = float(source.argument("soft"));
  const auto ambient = float(source.argument("ambient"));
  return paint(width, height, [&](glm::vec2 at) {
    const float distance = glm::length(at - 0.5f) / radius;
    const float inside = glm::clamp((1.0f - distance) / std::max(soft, 1e-3f), 0.0f, 1.0f);
    const float level = glm::mix(ambient, 1.0f, inside * inside * (3.0f - 2.0f * inside));
    return glm::vec4(level);
  });
}

Image makeBricks(const TextureSource &source, int width, int height) {
  const float rows = std::floor(float(source.argument("rows")));
  const float columns = std::floor(float(source.argument("columns")));
  const auto mortar = float(source.argument("mortar"));
  const bool heights = source.argument("gray") > 0;
  return paint(width, height, [&](glm::vec2 at) {
    glm::vec2 place(at.x * columns, at.y * rows);
    const float row = std::floor(place.y);
    place.x = std::fmod(place.x + 0.5f * std::fmod(row, 2.0f), columns);
    const glm::vec2 inside = glm::fract(place);
    // Mortar is as wide between the bricks of a row as between rows.
    const glm::vec2 joint = glm::max(glm::vec2(mortar * columns / rows, mortar), 1e-6f);
    const glm::vec2 edge = glm::min(inside, 1.0f - inside) / joint;
    const float level = glm::clamp(std::min(edge.x, edge.y), 0.0f, 1.0f);
    const float shade = 0.75f + 0.25f * randomAt(int(place.x), int(row), 3);
    const glm::vec3 brick = shade * glm::vec3(0.70f, 0.28f, 0.20f);
    return heights ? grey(level)
                   : glm::vec4(glm::mix(glm::vec3(0.72f, 0.70f, 0.66f), brick,
                                        level < 0.5f ? 0.0f : 1.0f),
                               1.0f);
  });
}

Image makeBumps(const TextureSource &source, int width, int height) {
  const float count = std::floor(float(source.argument("count")));
  const auto radius = float(source.argument("radius"));
  return paint(width, height, [&](glm::vec2 at) {
    const float distance = glm::length(glm::fract(at * count) - 0.5f) / radius;
    return grey(std::sqrt(std::max(0.0f, 1.0f - distance * distance)));
  });
}

Image makeHairs(const TextureSource &source, int width, int height) {
  const auto density = float(source.argument("density"));
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool stands = randomAt(x, y, seedOf(source)) < density;
      const float length = 0.4f + 0.6f * randomAt(x, y, seedOf(source) + 1);
      const float shade = 0.6f + 0.4f * randomAt(x, y, seedOf(source) + 2);
      image.set(x, y, {0.85f * shade, 0.6f * shade, 0.35f * shade, stands ? length : 0.0f});
    }
  return image;
}

Image makeCells(const TextureSource &source, int width, int height) {
  const auto density = float(source.argument("density"));
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.set(x, y, grey(randomAt(x, y, seedOf(source)) < density ? 1.0f : 0.0f));
  return image;
}

Image makeRule() {
  Image image(2, 16);
  for (int around = 0; around < 16; ++around)
    for (const bool self : {false, true}) {
      const int neighbours = around - int(self);
      const bool lives = neighbours == 3 || (self && neighbours == 2);
      const glm::vec4 alive = self ? glm::vec4(1.0f) : glm::vec4(1.0f, 0.8f, 0.2f, 1.0f);
      const glm::vec4 dead = self ? glm::vec4(0.0f, 0.4f, 0.8f, 1.0f) : glm::vec4(0, 0, 0, 1);
      image.set(int(self), around, lives ? alive : dead);
    }
  return image;
}

} // namespace arbiter::scene
