#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include <GL/gl.h>

#include "state/imaging/pixels.h"

/// Operations that only count pixels.
namespace arbiter::state::imaging {

/// A bin's counters. In a format with luminance, red's counter is luminance's.
using Counts = std::array<std::uint32_t, 4>;

struct Histogram {
  GLenum format = GL_RGBA;
  bool sink = false;
  std::vector<Counts> bins;

  void count(const Pixels &pixels);
};

struct Minmax {
  static constexpr float kMax = std::numeric_limits<float>::max();

  GLenum format = GL_RGBA;
  bool sink = false;
  Rgba least = {kMax, kMax, kMax, kMax};
  Rgba most = {-kMax, -kMax, -kMax, -kMax};

  void count(const Pixels &pixels);
};

/// True if a table of the format counts the component.
[[nodiscard]] bool counts(GLenum format, int component);

} // namespace arbiter::state::imaging
