#pragma once
#include <cmath>
#include <type_traits>

#include <GL/gl.h>

#include "state/imaging/pixels.h"

/// What queries of tables and filters have in common.
namespace arbiter::state {

class Context;

/// Four values, whole numbers rounded (OpenGL 2.1, 6.1.2).
template <typename T> void giveColor(const imaging::Rgba &color, T *to) {
  for (std::size_t c = 0; c < 4; ++c)
    if constexpr (std::is_integral_v<T>)
      to[c] = T(std::lround(color[c]));
    else
      to[c] = color[c];
}

/// An image of selected colours as the application asks for it; components that its internal format
/// lacks are 0. Errors are raised. False: nothing was written.
bool returnImage(Context &context, GLenum internalFormat, const imaging::Pixels &image,
                 GLenum format, GLenum type, void *to);

} // namespace arbiter::state
