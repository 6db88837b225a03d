#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

#include "state/imaging/pixels.h"

namespace arbiter::state::imaging {

/// A convolution filter; one of a dimension alone has a height of 1. Its colours are selected by
/// the format, and may be any numbers.
struct Filter {
  GLenum format = GL_RGBA;
  Pixels image;

  [[nodiscard]] bool empty() const { return image.texels.empty(); }
};

/// The filter whose product a separable one's row and column are.
[[nodiscard]] Filter product(const Filter &row, const Filter &column);

struct Border {
  GLenum mode = GL_REDUCE;
  Rgba color = {0, 0, 0, 0};

  bool operator==(const Border &) const = default;
};

/// OpenGL 2.1, 3.6.5, Convolution. With REDUCE the image loses the filter's size less one, down to
/// nothing; a component that the filter's format does not act on is that of the pixel under the
/// filter's middle. An image of one row is convolved as one of a dimension alone.
[[nodiscard]] Pixels convolve(const Pixels &source, const Filter &filter, const Border &border);
/// The size that a side of an image is left with.
[[nodiscard]] int convolvedSize(int size, int filter, const Border &border);

} // namespace arbiter::state::imaging
