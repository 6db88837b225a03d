#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

#include "state/imaging/pixels.h"

namespace arbiter::state::imaging {

/// A convolution filter; height 1 if it is one-dimensional. It has the components of its format,
/// with any values.
struct Filter {
  GLenum format = GL_RGBA;
  Pixels image;

  [[nodiscard]] bool empty() const { return image.texels.empty(); }
};

/// Returns the two-dimensional filter that equals a separable one.
[[nodiscard]] Filter product(const Filter &row, const Filter &column);

struct Border {
  GLenum mode = GL_REDUCE;
  Rgba color = {0, 0, 0, 0};

  bool operator==(const Border &) const = default;
};

/// Convolves an image (OpenGL 2.1, 3.6.5, Convolution). With REDUCE the image shrinks by the
/// filter's size less one, at most to nothing. A component that the filter's format lacks is taken
/// from the pixel under the filter's middle. An image of one row is convolved in one dimension.
[[nodiscard]] Pixels convolve(const Pixels &source, const Filter &filter, const Border &border);
/// Returns the size of an image's side after convolution.
[[nodiscard]] int convolvedSize(int size, int filter, const Border &border);

} // namespace arbiter::state::imaging
