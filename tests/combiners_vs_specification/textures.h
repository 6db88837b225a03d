#pragma once
#include <vector>

#include <epoxy/gl.h>

#include "fp_compiler/testing/evaluate_combiners.h"
#include "fp_compiler/testing/random.h"

namespace combined {

/// A texture of one texel, so that no coordinate matters but the one a depth is compared with.
struct Texture {
  GLuint name = 0;
  GLenum target = GL_TEXTURE_2D;
  arbiter::fp::combiners::Color contents{}; ///< of its texture register (table RC.2)
  bool compares = false; ///< `contents` is then the depth, which r is compared with: r <= depth
};

/// Of each target and base internal format some, with texels of a fixed seed, in the current
/// context.
[[nodiscard]] std::vector<Texture>
makeTextures(bool negative); ///< negative: one has texels below zero

} // namespace combined
