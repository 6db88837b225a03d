#include "apps/scene/texture/noise.h"

#include <glm/common.hpp>

namespace arbiter::scene {

namespace {

int wrapped(int x, int period) { return period == 0 ? x : ((x % period) + period) % period; }

/// Computes floor() inline, without a call.
int floorOf(float value) {
  const int towardsZero = int(value);
  return towardsZero - int(float(towardsZero) > value);
}

float smoothNoise(glm::vec2 at, int period, std::uint32_t seed) {
  const int x = floorOf(at.x), y = floorOf(at.y);
  glm::vec2 f = at - glm::vec2(float(x), float(y));
  f = f * f * (3.0f - 2.0f * f);
  const auto corner = [&](int dx, int dy) {
    return randomAt(wrapped(x + dx, period), wrapped(y + dy, period), seed);
  };
  return glm::mix(glm::mix(corner(0, 0), corner(1, 0), f.x),
                  glm::mix(corner(0, 1), corner(1, 1), f.x), f.y);
}

} // namespace

std::uint32_t hashOf(int x, int y, std::uint32_t seed) {
  // The mixing is of Marsaglia's and Jenkins's kind: products and shifts until each bit depends on
  // all.
  std::uint32_t h =
      std::uint32_t(x) * 0x9E3779B1u ^ std::uint32_t(y) * 0x85EBCA77u ^ (seed + 1) * 0xC2B2AE3Du;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return h ^ (h >> 15);
}

float fractalNoise(glm::vec2 at, int octaves, int period, std::uint32_t seed) {
  float sum = 0, weight = 0.5f, total = 0;
  for (int i = 0; i < octaves; ++i) {
    sum += weight * smoothNoise(at, period, seed + std::uint32_t(i));
    total += weight;
    at *= 2.0f;
    period *= 2;
    weight *= 0.5f;
  }
  return sum / total;
}

} // namespace arbiter::scene
