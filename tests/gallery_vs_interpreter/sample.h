#pragma once
#include <vector>

#include "apps/scene/panel/panel.h"
#include "apps/scene/texture/image.h"
#include "fp_compiler/ir/evaluate.h"

/// Samples textures in plain C++ (GL 2.1, 3.8), without mipmaps.
namespace gallery {

namespace ir = arbiter::fp::ir;

struct Texture {
  /// One image, or six faces. A depth texture's color is the depth.
  std::vector<arbiter::scene::Image> images;
  std::vector<float> depths; ///< replace the image's texels
  bool nearest = false;
  arbiter::scene::Wrap wrap = arbiter::scene::Wrap::Repeat;

  [[nodiscard]] glm::vec4 texel(std::size_t face, int x, int y) const;
};

[[nodiscard]] ir::Vec4 sample(const Texture &texture, const ir::Sample &at);

} // namespace gallery
