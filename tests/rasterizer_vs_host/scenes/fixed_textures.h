#pragma once
#include "surface.h"

/// The random textures of fixed function's draws (fixed_states.cpp).
namespace software {

struct FixedTexture {
  GLuint name = 0;
  GLenum target = 0;
  GLint format = 0; ///< a base format of colors, or a depth format
  [[nodiscard]] bool isDepth() const;
  /// True if DECAL is defined for it (OpenGL 1.4, table 3.21).
  [[nodiscard]] bool hasDecal() const { return format == GL_RGB || format == GL_RGBA; }
};

/// Makes a texture of any target with random texels, wraps and border, on the active unit.
/// \param levels adds levels of detail, and a filter between them
[[nodiscard]] FixedTexture makeFixedTexture(Random &random, bool levels);

/// Chooses how a depth texture on the active unit is sampled: TEXTURE_COMPARE_MODE and _FUNC,
/// DEPTH_TEXTURE_MODE, and the filter. \param levels as above
void chooseComparison(Random &random, const FixedTexture &texture, bool levels);

} // namespace software
