#include "apps/scene/texture/image.h"

#include <algorithm>
#include <cmath>

namespace arbiter::scene {

Image::Image(const Picture &picture)
    : width(picture.width), height(picture.height),
      texels(picture.bytes.begin(), picture.bytes.end()) {}

glm::vec4 Image::at(int x, int y) const {
  const std::size_t first = 4 * (std::size_t(y) * std::size_t(width) + std::size_t(x));
  glm::vec4 color;
  for (int i = 0; i < 4; ++i)
    color[i] = float(texels[first + std::size_t(i)]) / most();
  return color;
}

void Image::set(int x, int y, const glm::vec4 &color) {
  const std::size_t first = 4 * (std::size_t(y) * std::size_t(width) + std::size_t(x));
  for (int i = 0; i < 4; ++i)
    texels[first + std::size_t(i)] =
        std::uint16_t(std::lround(std::clamp(color[i], 0.0f, 1.0f) * most()));
}

Picture Image::picture() const {
  Picture picture{width, height, {}};
  picture.bytes.reserve(texels.size());
  for (const std::uint16_t texel : texels)
    picture.bytes.push_back(std::uint8_t(bits == 16 ? (texel * 255u + 32767u) / 65535u : texel));
  return picture;
}

} // namespace arbiter::scene
