#pragma once
#include <vector>

#include <epoxy/gl.h>

#include "fp_compiler/testing/evaluate_combiners.h"
#include "fp_compiler/testing/random.h"

namespace combined {

/// A texture of one texel, so that only the coordinate that a depth is compared with matters.
struct Texture {
  GLuint name = 0;
  GLenum target = GL_TEXTURE_2D;
  arbiter::fp::combiners::Color contents{}; ///< of its texture register (table RC.2)
  bool compares = false; ///< `contents` is then the depth that r is compared with: r <= depth
};

/// Makes some textures of each target and base internal format in the current context, with texels
/// from a fixed seed.
[[nodiscard]] std::vector<Texture>
makeTextures(bool negative); ///< negative: one has texels below zero

} // namespace combined
