#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

/// Records how clipping creates vertices, so that their inputs are computed by the hosts' steps.
namespace arbiter::swrast {

/// A list of points derived from a primitive's vertices. Places 0 to 2 are the vertices. Each
/// further place lies between two earlier ones.
struct Cuts {
  struct Step {
    std::uint8_t near, far;
    float share; ///< fraction of the way from `near` to `far`
  };
  /// Every plane may cut twice, and line stipple may cut twice more.
  static constexpr int kMax = 40;
  static constexpr int kVertices = 3;
  std::array<Step, kMax> step;
  int count = 0;

  /// Adds a place and returns its number.
  std::uint8_t add(std::uint8_t near, std::uint8_t far, float share) {
    step[std::size_t(count)] = {near, far, share};
    return std::uint8_t(kVertices + count++);
  }
  /// Computes a component at all places.
  /// \param value the vertices' values are set; receives the others
  void follow(float (&value)[kVertices + kMax]) const {
    for (int i = 0; i < count; ++i) {
      const Step &own = step[std::size_t(i)];
      const float from = value[own.near];
      value[kVertices + i] = from + own.share * (value[own.far] - from);
    }
  }
};

} // namespace arbiter::swrast
