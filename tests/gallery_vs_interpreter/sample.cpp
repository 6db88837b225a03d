#include "sample.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace gallery {

namespace {

using arbiter::scene::Wrap;

int wrapped(int at, int size, Wrap wrap) {
  switch (wrap) {
  case Wrap::Edge:
    return std::clamp(at, 0, size - 1);
  case Wrap::Mirror: {
    const int folded = ((at % (2 * size)) + 2 * size) % (2 * size);
    return folded < size ? folded : 2 * size - 1 - folded;
  }
  case Wrap::Repeat:
    break;
  }
  return ((at % size) + size) % size;
}

glm::vec4 filtered(const Texture &texture, std::size_t face, float s, float t, Wrap wrap) {
  const auto &image = texture.images[face];
  const auto texel = [&](double x, double y) {
    return texture.texel(face, wrapped(int(x), image.width, wrap),
                         wrapped(int(y), image.height, wrap));
  };
  const double u = double(s) * image.width, v = double(t) * image.height;
  if (texture.nearest)
    return texel(std::floor(u), std::floor(v));
  const double x = std::floor(u - 0.5), y = std::floor(v - 0.5);
  const auto fx = float(u - 0.5 - x), fy = float(v - 0.5 - y);
  return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), fx),
                  glm::mix(texel(x, y + 1), texel(x + 1, y + 1), fx), fy);
}

/// The face that a direction points to, and s and t on it in [0,1] (GL 2.1, table 3.19).
struct Faced {
  std::size_t face;
  float s, t;
};
Faced facedBy(const ir::Vec4 &direction) {
  const auto [x, y, z, unused] = direction;
  const float ax = std::abs(x), ay = std::abs(y), az = std::abs(z);
  float sc, tc, major;
  std::size_t face;
  if (ax >= ay && ax >= az) {
    face = x >= 0 ? 0 : 1;
    sc = x >= 0 ? -z : z;
    tc = -y;
    major = ax;
  } else if (ay >= az) {
    face = y >= 0 ? 2 : 3;
    sc = x;
    tc = y >= 0 ? z : -z;
    major = ay;
  } else {
    face = z >= 0 ? 4 : 5;
    sc = z >= 0 ? x : -x;
    tc = -y;
    major = az;
  }
  return {face, (sc / major + 1) / 2, (tc / major + 1) / 2};
}

} // namespace

glm::vec4 Texture::texel(std::size_t face, int x, int y) const {
  const auto &image = images[face];
  if (depths.empty())
    return image.at(x, y);
  const float depth = depths[std::size_t(y) * std::size_t(image.width) + std::size_t(x)];
  return {depth, depth, depth, 1.0f};
}

ir::Vec4 sample(const Texture &texture, const ir::Sample &at) {
  glm::vec4 color;
  if (at.target == ir::TexTarget::Cube) {
    const Faced faced = facedBy(at.coordinate);
    color = filtered(texture, faced.face, faced.s, faced.t, Wrap::Edge);
  } else if (at.target == ir::TexTarget::Tex1D) {
    color = filtered(texture, 0, at.coordinate[0], 0.5f, texture.wrap);
  } else {
    color = filtered(texture, 0, at.coordinate[0], at.coordinate[1], texture.wrap);
  }
  return {color.x, color.y, color.z, color.w};
}

} // namespace gallery
