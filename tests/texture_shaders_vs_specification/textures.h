#pragma once
#include <vector>

#include <epoxy/gl.h>

#include "fp_compiler/testing/evaluate_texture_shaders.h"
#include "fp_compiler/testing/random.h"

namespace shaded {

/// A texture with known texels, sampled with NEAREST and CLAMP_TO_EDGE.
struct Texture {
  GLuint name = 0;
  GLenum target = GL_TEXTURE_2D;
  arbiter::fp::texture_shader::Texture kind; ///< Base::None: incomplete
  GLenum format = 0;                         ///< its internal format
  int width = 1, height = 1, depth = 1;      ///< the depth of a cube map is its six faces
  std::vector<arbiter::fp::texture_shader::Color> texels;

  [[nodiscard]] arbiter::fp::texture_shader::Sampled
  at(const std::array<double, 3> &coordinate) const;
};

/// Makes one texture of each target and internal format in the current context. Signed ones, and
/// those of HILO components and texture offset groups, are made from pixels of every kind.
/// \param peer converts signed bytes to floats as NVIDIA's driver does
[[nodiscard]] std::vector<Texture> makeTextures(bool peer);

} // namespace shaded
