#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <GL/gl.h>

#include "state/imaging/pixels.h"

/// What queries of tables and filters have in common.
namespace arbiter::state {

class Context;

/// To a whole number of the type, the nearest that it has; 0 for what is no number.
template <typename T> [[nodiscard]] T wholeNumber(double value) {
  constexpr auto kMost = double(std::numeric_limits<T>::max());
  const double nearest = std::floor(value + 0.5);
  if (!(nearest < kMost))
    return std::isnan(nearest) ? T(0) : std::numeric_limits<T>::max();
  return T(std::max(nearest, double(std::numeric_limits<T>::min())));
}

/// Four values, whole numbers rounded (OpenGL 2.1, 6.1.2).
template <typename T> void giveColor(const imaging::Rgba &color, T *to) {
  for (std::size_t c = 0; c < 4; ++c)
    if constexpr (std::is_integral_v<T>)
      to[c] = wholeNumber<T>(double(color[c]));
    else
      to[c] = color[c];
}

/// An image of selected colours as the application asks for it; components that its internal format
/// lacks are 0. Errors are raised. False: nothing was written.
bool returnImage(Context &context, GLenum internalFormat, const imaging::Pixels &image,
                 GLenum format, GLenum type, void *to);

} // namespace arbiter::state
