#include "state/imaging/arithmetic.h"

#include <cmath>

namespace arbiter::state::imaging {

std::size_t indexOf(float value, std::size_t entries) {
  return std::size_t(std::floor(double(clamped(value)) * double(entries - 1) + 0.5));
}

Rgba ScaleBias::apply(const Rgba &color) const {
  Rgba result;
  for (std::size_t c = 0; c < 4; ++c)
    result[c] = color[c] * scale[c] + bias[c];
  return result;
}

void ScaleBias::apply(Pixels &pixels) const {
  if (*this == ScaleBias{})
    return;
  for (Rgba &texel : pixels.texels)
    texel = apply(texel);
}

void transform(Pixels &pixels, const Matrix &matrix) {
  if (matrix == kIdentity)
    return;
  for (Rgba &texel : pixels.texels) {
    Rgba result;
    for (std::size_t row = 0; row < 4; ++row)
      result[row] = matrix[row] * texel[0] + matrix[4 + row] * texel[1] +
                    matrix[8 + row] * texel[2] + matrix[12 + row] * texel[3];
    texel = result;
  }
}

void FirstArithmetic::apply(Pixels &pixels) const {
  scaleBias.apply(pixels);
  if (!maps)
    return;
  for (Rgba &texel : pixels.texels)
    for (std::size_t c = 0; c < 4; ++c)
      if (!map[c].empty())
        texel[c] = map[c][indexOf(texel[c], map[c].size())];
}

} // namespace arbiter::state::imaging
