#pragma once
#include <cstdint>
#include <glm/vec2.hpp>

/// Noise that is the same at every call and on every machine.
namespace arbiter::scene {

/// 32 bits of a place of a lattice.
[[nodiscard]] std::uint32_t hashOf(int x, int y, std::uint32_t seed);
/// In [0,1].
[[nodiscard]] inline float randomAt(int x, int y, std::uint32_t seed) {
  return float(hashOf(x, y, seed) & 0xFFFFFF) / 16777215.0f;
}

/// Layers of smooth noise, in [0,1], each of twice the frequency and half the weight of the one
/// before.
/// \param at in cells of the lattice
/// \param period cells after which it repeats; 0: never
[[nodiscard]] float fractalNoise(glm::vec2 at, int octaves, int period = 0, std::uint32_t seed = 0);

} // namespace arbiter::scene
