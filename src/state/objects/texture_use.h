#pragma once
#include <cstdint>

#include <GL/gl.h>

#include "fp_compiler/ir/ir.h"

namespace arbiter::state {

/// The texture of a unit that a program samples, at the program's first draw.
struct TextureUse {
  std::uint8_t unit = 0;
  fp::ir::TexTarget target = fp::ir::TexTarget::Tex2D;
  GLint name = 0;
  GLint width = 0, height = 0, depth = 0; ///< texels; 0: no image
  GLint format = 0;                       ///< internal format
  std::uint8_t enabled = 0; ///< fixed-function targets of the unit: bit i is kFixedTargets[i]
};

} // namespace arbiter::state
