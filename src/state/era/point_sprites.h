#pragma once
#include <cstdint>

#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

/// The source of the third component of sprite coordinates: the vertex's s or r, divided by q.
struct SpriteForm {
  std::uint8_t units = 0; ///< with COORD_REPLACE, one bit each; 0: plain sprites of the host
  std::uint8_t fromS = 0; ///< 1: from S, else from R
  bool operator==(const SpriteForm &) const = default;
};

/// NV_point_sprite on top of ARB_point_sprite: POINT_SPRITE_R_MODE_NV, and what the host's draws
/// need for it (programs/variants/point_sprites.h).
struct PointSprites {
  static constexpr GLenum kNoPrimitive = ~0u;

  GLenum rMode = GL_ZERO; ///< ZERO, S or R
  /// A mode other than ZERO was set once, or recorded in a list.
  bool used = false;
  GLenum drawn = kNoPrimitive; ///< mode of the next draw; kNoPrimitive: it has none
  SpriteForm form;             ///< the effective program was chosen for it
  /// Units whose COORD_REPLACE the application set to TRUE, and the layer to FALSE on the host.
  std::uint8_t hidden = 0;
};

} // namespace arbiter::state
