#pragma once
#include "surface.h"

/// The textures of fixed function's draws by chance (fixed_states.cpp).
namespace software {

struct FixedTexture {
  GLuint name = 0;
  GLenum target = 0;
  GLint format = 0; ///< a base format of colours, or a format of depths
  [[nodiscard]] bool isDepth() const;
  /// Whether DECAL is defined for it (OpenGL 1.4, table 3.21).
  [[nodiscard]] bool hasDecal() const { return format == GL_RGB || format == GL_RGBA; }
};

/// A texture of any target with texels, wraps and border by chance, on the active unit.
/// \param levels with levels of detail, and a filter between them
[[nodiscard]] FixedTexture makeFixedTexture(Random &random, bool levels);

/// How a texture of depths is sampled, by chance: TEXTURE_COMPARE_MODE and _FUNC,
/// DEPTH_TEXTURE_MODE, and the filter. On the active unit; `levels` as above.
void chooseComparison(Random &random, const FixedTexture &texture, bool levels);

} // namespace software
