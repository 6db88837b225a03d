#pragma once
#include <cstdint>

#include <GL/gl.h>

#include "state/mirror/attributes.h"

/// Elements of vertex arrays as floats.
namespace arbiter::state::software {

/// Converts `count` elements from `base` on: component c of element i goes to to[c][i], for the
/// components that the array has. Nothing need be aligned.
struct Conversion {
  const std::uint8_t *base = nullptr;
  std::size_t stride = 0;
  std::uint32_t count = 0;
  float *to[4] = {};
};
using Convert = void (*)(const Conversion &);
/// Null where the type, or the type with these components, is unknown.
[[nodiscard]] Convert conversionOf(const VertexSource::Array &array, bool symmetric);

} // namespace arbiter::state::software
