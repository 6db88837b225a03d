#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

/// The steps by which hosts make the inputs of vertices that clipping creates.
namespace arbiter::swrast {

/// Places that are made of a primitive's vertices: places 0 to 2 are those, each further one lies
/// between two that were there before.
struct Cuts {
  struct Step {
    std::uint8_t near, far;
    float share; ///< of the way from `near` to `far`
  };
  /// All planes cut twice each at most, and the stipple of a line twice more.
  static constexpr int kMost = 40;
  static constexpr int kVertices = 3;
  std::array<Step, kMost> step;
  int count = 0;

  /// Adds a place and returns its number.
  std::uint8_t add(std::uint8_t near, std::uint8_t far, float share) {
    step[std::size_t(count)] = {near, far, share};
    return std::uint8_t(kVertices + count++);
  }
  /// A component at all places. \param value those of the vertices are set
  void follow(float (&value)[kVertices + kMost]) const {
    for (int i = 0; i < count; ++i) {
      const Step &own = step[std::size_t(i)];
      const float from = value[own.near];
      value[kVertices + i] = from + own.share * (value[own.far] - from);
    }
  }
};

} // namespace arbiter::swrast
