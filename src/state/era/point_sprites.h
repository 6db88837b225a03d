#pragma once
#include <cstdint>

#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

/// What points are drawn with where a texture coordinate keeps something of the vertex's: the third
/// component of the sprites' coordinates is the vertex's s or r, over q.
struct SpriteForm {
  std::uint8_t units = 0; ///< with COORD_REPLACE, one bit each; 0: as the host has sprites
  std::uint8_t fromS = 0; ///< 1: of S, else of R
  bool operator==(const SpriteForm &) const = default;
};

/// NV_point_sprite over ARB_point_sprite: POINT_SPRITE_R_MODE_NV, and what draws on the host need
/// of it (programs/variants/point_sprites.h).
struct PointSprites {
  static constexpr GLenum kNoPrimitive = ~0u;

  GLenum rMode = GL_ZERO; ///< or S, or R
  /// A mode other than ZERO was set here once, or put into a list.
  bool used = false;
  GLenum drawn = kNoPrimitive; ///< the mode of the next draw; kNoPrimitive: it has none
  SpriteForm form;             ///< that the effective program was chosen for
  /// Units whose COORD_REPLACE is TRUE to the application, and FALSE on the host for now.
  std::uint8_t hidden = 0;
};

} // namespace arbiter::state
