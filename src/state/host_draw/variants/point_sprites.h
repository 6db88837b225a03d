#pragma once
#include <GL/gl.h>

#include "state/era/point_sprites.h"

/// POINT_SPRITE_R_MODE_NV (NV_point_sprite) of S and R on a host, which replaces all four
/// components of a unit's coordinates by (s, t, 0, 1). Points are drawn with a form of the fragment
/// program that reads gl_PointCoord, and the vertex's coordinates beside it: COORD_REPLACE of the
/// units is FALSE on the host meanwhile. Fixed function is a program then. The rasterizer has the
/// mode by itself.
namespace arbiter::state {

class Context;

/// A mode was set that draws look at each time.
[[nodiscard]] bool mayFollowSprites(const Context &context);
/// Notes the mode of the draw that comes, outside of lists; `PointSprites::kNoPrimitive` of one
/// without.
void notePrimitiveMode(Context &context, GLenum mode);
/// Before the choice of what is effective: another one is made if the draw needs another form. Asks
/// the host.
void followSprites(Context &context);
/// POINT_SPRITE_R_MODE_NV; ZERO where the layer does not have it.
[[nodiscard]] GLenum spriteMode(const Context &context);
/// The form that the effective program is chosen for.
[[nodiscard]] SpriteForm spriteForm(const Context &context);
/// After the choice: the host's COORD_REPLACE is what the program of the draw needs.
void applySprites(Context &context);

/// The host's COORD_REPLACE becomes the application's again; the next draw looks.
void releaseSprites(Context &context);

/// PointParameter of POINT_SPRITE_R_MODE_NV, outside of lists, with its errors.
void setSpriteMode(Context &context, GLenum mode);

} // namespace arbiter::state
