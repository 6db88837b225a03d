#pragma once
#include <cstdint>

#include <GL/gl.h>

#include "state/mirror/attributes.h"

/// Converts elements of vertex arrays to floats.
namespace arbiter::state {

/// A conversion of `count` elements from `base` on. Component c of element i goes to to[c][i], for
/// the components that the array has. No alignment is required.
struct Conversion {
  const std::uint8_t *base = nullptr;
  std::size_t stride = 0;
  std::uint32_t count = 0;
  float *to[4] = {};
};
using Convert = void (*)(const Conversion &);
/// Returns the function for an array, or null if the type, or its number of components, is unknown.
/// \param symmetric selects the rule of OpenGL 4.2 for signed numbers
[[nodiscard]] Convert conversionOf(const VertexSource::Array &array, bool symmetric);

} // namespace arbiter::state
