#pragma once
#include <cstdint>
#include <glm/vec2.hpp>

/// Noise that is the same at every call and on every machine.
namespace arbiter::scene {

/// Returns 32 bits for a point of a lattice.
[[nodiscard]] std::uint32_t hashOf(int x, int y, std::uint32_t seed);
/// Returns a number in [0,1].
[[nodiscard]] inline float randomAt(int x, int y, std::uint32_t seed) {
  return float(hashOf(x, y, seed) & 0xFFFFFF) / 16777215.0f;
}

/// Sums layers of smooth noise, in [0,1]. Each has twice the frequency and half the weight of the
/// one before.
/// \param at in cells of the lattice
/// \param period cells after which it repeats; 0: never
[[nodiscard]] float fractalNoise(glm::vec2 at, int octaves, int period = 0, std::uint32_t seed = 0);

} // namespace arbiter::scene
