#pragma once
#include <vector>

#include <epoxy/gl.h>

#include "fp_compiler/testing/evaluate_texture_shaders.h"
#include "fp_compiler/testing/random.h"

namespace shaded {

/// A texture whose texels are known, sampled with NEAREST and CLAMP_TO_EDGE.
struct Texture {
  GLuint name = 0;
  GLenum target = GL_TEXTURE_2D;
  arbiter::fp::texture_shader::Texture kind; ///< Base::None: incomplete
  GLenum format = 0;                         ///< its internal format
  int width = 1, height = 1, depth = 1;      ///< a cube map's depth: six faces
  std::vector<arbiter::fp::texture_shader::Color> texels;

  [[nodiscard]] arbiter::fp::texture_shader::Sampled
  at(const std::array<double, 3> &coordinate) const;
};

/// One of each target and internal format, made in the current context; signed ones and those of
/// HILO components and texture offset groups by pixels of every kind.
/// \param peer signed bytes of floats are as NVIDIA's driver stores them
[[nodiscard]] std::vector<Texture> makeTextures(bool peer);

} // namespace shaded
