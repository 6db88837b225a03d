#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <GL/gl.h>

#include "state/imaging/pixels.h"

/// Helpers for queries of tables and filters.
namespace arbiter::state {

struct RasterContext;

/// Returns the nearest integer of the type; 0 for NaN.
template <typename T> [[nodiscard]] T wholeNumber(double value) {
  constexpr auto kMax = double(std::numeric_limits<T>::max());
  const double nearest = std::floor(value + 0.5);
  if (!(nearest < kMax))
    return std::isnan(nearest) ? T(0) : std::numeric_limits<T>::max();
  return T(std::max(nearest, double(std::numeric_limits<T>::min())));
}

/// Returns four values, rounded for integer types (OpenGL 2.1, 6.1.2).
template <typename T> void giveColor(const imaging::Rgba &color, T *to) {
  for (std::size_t c = 0; c < 4; ++c)
    if constexpr (std::is_integral_v<T>)
      to[c] = wholeNumber<T>(double(color[c]));
    else
      to[c] = color[c];
}

/// Returns an image to the application. Components that its internal format lacks are 0. Raises
/// errors. Returns false if nothing was written.
bool returnImage(RasterContext &context, GLenum internalFormat, const imaging::Pixels &image,
                 GLenum format, GLenum type, void *to);

} // namespace arbiter::state
