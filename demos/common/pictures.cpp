#include "common/pictures.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string_view>

namespace demos {
namespace {

float latticeValue(int x, int y) {
  std::uint32_t h = std::uint32_t(x) * 0x9E3779B1u ^ std::uint32_t(y) * 0x85EBCA77u;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return float((h ^ (h >> 15)) & 0xFFFF) / 65535.0f;
}

float valueNoise(glm::vec2 at) {
  const glm::vec2 cell = glm::floor(at);
  glm::vec2 f = at - cell;
  f = f * f * (3.0f - 2.0f * f);
  const int x = int(cell.x), y = int(cell.y);
  return glm::mix(glm::mix(latticeValue(x, y), latticeValue(x + 1, y), f.x),
                  glm::mix(latticeValue(x, y + 1), latticeValue(x + 1, y + 1), f.x), f.y);
}

/// A letter as rows of five bits, the top one first.
struct Glyph {
  char letter;
  std::array<std::uint8_t, 7> rows;
};
constexpr Glyph kGlyphs[] = {
    {'A', {0x0E, 0x11, 0x11, 0x1F, 0x11, 0x11, 0x11}},
    {'R', {0x1E, 0x11, 0x11, 0x1E, 0x14, 0x12, 0x11}},
    {'B', {0x1E, 0x11, 0x11, 0x1E, 0x11, 0x11, 0x1E}},
    {'I', {0x0E, 0x04, 0x04, 0x04, 0x04, 0x04, 0x0E}},
    {'T', {0x1F, 0x04, 0x04, 0x04, 0x04, 0x04, 0x04}},
    {'E', {0x1F, 0x10, 0x10, 0x1E, 0x10, 0x10, 0x1F}},
    {'!', {0x04, 0x04, 0x04, 0x04, 0x04, 0x00, 0x04}},
    {'f', {0x06, 0x09, 0x08, 0x1C, 0x08, 0x08, 0x08}},
    {'p', {0x00, 0x00, 0x1E, 0x11, 0x1E, 0x10, 0x10}},
    {'1', {0x04, 0x0C, 0x04, 0x04, 0x04, 0x04, 0x0E}},
    {'0', {0x0E, 0x11, 0x13, 0x15, 0x19, 0x11, 0x0E}},
    {'.', {0x00, 0x00, 0x00, 0x00, 0x00, 0x0C, 0x0C}},
};

/// True if \p at, in units of one glyph dot from the text's lower left, is inked.
bool inked(std::string_view text, glm::vec2 at) {
  const int x = int(std::floor(at.x)), y = int(std::floor(at.y));
  if (x < 0 || y < 0 || y >= 7 || std::size_t(x / 6) >= text.size() || x % 6 == 5)
    return false;
  for (const Glyph &glyph : kGlyphs)
    if (glyph.letter == text[std::size_t(x / 6)])
      return glyph.rows[std::size_t(6 - y)] >> (4 - x % 6) & 1;
  return false;
}

glm::vec3 sky(glm::vec2 p) {
  const float up = glm::clamp((p.y - 0.35f) / 0.65f, 0.0f, 1.0f);
  glm::vec3 color =
      glm::mix(glm::vec3(1.0f, 0.78f, 0.55f), glm::vec3(0.16f, 0.36f, 0.74f), std::pow(up, 0.6f));
  const float distance = glm::length(p - glm::vec2(0.72f, 0.74f));
  color += glm::vec3(1.0f, 0.75f, 0.35f) * 0.35f * std::exp(-distance * 9.0f);
  color = glm::mix(glm::vec3(1.0f, 0.96f, 0.78f), color, glm::smoothstep(0.083f, 0.087f, distance));
  const float cloud = fractalNoise(p * glm::vec2(5.0f, 12.0f) + 3.0f, 5);
  const float cover = glm::smoothstep(0.5f, 0.8f, cloud) * glm::smoothstep(0.4f, 0.6f, p.y);
  return glm::mix(color, glm::vec3(0.97f, 0.95f, 0.96f), 0.85f * cover);
}

glm::vec3 ground(glm::vec2 p) {
  const float depth = 0.06f / (0.352f - p.y);
  const glm::vec2 tile((p.x - 0.5f) * depth * 40.0f, depth * 9.0f);
  const bool dark = (int(std::floor(tile.x)) + int(std::floor(tile.y))) & 1;
  const glm::vec3 color = dark ? glm::vec3(0.16f, 0.22f, 0.16f) : glm::vec3(0.80f, 0.74f, 0.60f);
  // Far tiles are smaller than a pixel and fade into haze.
  return glm::mix(color, glm::vec3(0.62f, 0.60f, 0.55f), glm::smoothstep(0.27f, 0.345f, p.y));
}

/// Colors a white board with dark lettering; returns false outside of it.
bool board(glm::vec2 p, glm::vec3 &color) {
  const glm::vec2 corner(0.07f, 0.12f), size(0.42f, 0.19f);
  const glm::vec2 inside = (p - corner) / size;
  if (inside.x < 0 || inside.y < 0 || inside.x > 1 || inside.y > 1)
    return false;
  const bool frame = inside.x < 0.02f || inside.y < 0.045f || inside.x > 0.98f || inside.y > 0.955f;
  color = frame ? glm::vec3(0.45f, 0.08f, 0.06f) : glm::vec3(0.95f, 0.94f, 0.90f);
  const glm::vec2 dots = (p - corner) * 156.0f;
  if (inked("!!ARBfp1.0", dots - glm::vec2(3.0f, 18.0f)))
    color = glm::vec3(0.10f, 0.10f, 0.14f);
  if (inked("ARBITER", dots - glm::vec2(3.0f, 6.0f)))
    color = glm::vec3(0.75f, 0.22f, 0.10f);
  return true;
}

glm::vec3 landscape(glm::vec2 p) {
  glm::vec3 color = p.y < 0.35f ? ground(p) : sky(p);
  const float far = 0.40f + 0.16f * fractalNoise({p.x * 4.0f, 7.5f}, 5) * (1.1f - p.x);
  const float near = 0.35f + 0.12f * fractalNoise({p.x * 6.0f + 9.0f, 2.5f}, 5) * (0.2f + p.x);
  if (p.y >= 0.35f && p.y < far)
    color = glm::mix(glm::vec3(0.36f, 0.40f, 0.55f), glm::vec3(0.62f, 0.58f, 0.60f),
                     glm::smoothstep(far, 0.35f, p.y));
  if (p.y >= 0.35f && p.y < near)
    color = glm::vec3(0.14f, 0.26f, 0.16f) * (0.75f + 0.5f * fractalNoise(p * 60.0f, 3));
  board(p, color);
  return color;
}

} // namespace

float fractalNoise(glm::vec2 at, int octaves) {
  float sum = 0, weight = 0.5f, total = 0;
  for (int i = 0; i < octaves; ++i) {
    sum += weight * valueNoise(at);
    total += weight;
    at = at * 2.0f + 17.0f;
    weight *= 0.5f;
  }
  return sum / total;
}

Image makeLandscape(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.set(x, y, glm::vec4(landscape(image.coordinate(x, y)), 1.0f));
  return image;
}

} // namespace demos
