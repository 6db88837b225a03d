#pragma once
#include <GL/gl.h>

#include "state/core/context.h"
#include "state/era/era_state.h"
#include "state/era/point_sprites.h"

/// POINT_SPRITE_R_MODE_NV (NV_point_sprite) of S and R on a host, which replaces all four
/// components of a unit's coordinates by (s, t, 0, 1). Points are drawn with a form of the fragment
/// program that reads gl_PointCoord, and the vertex's coordinates beside it: COORD_REPLACE of the
/// units is FALSE on the host meanwhile. Fixed function is a program then. The rasterizer has the
/// mode by itself.
namespace arbiter::state {

/// Null where the layer does not have the extension.
[[nodiscard]] inline PointSprites *spritesOf(const Context &context) {
  return context.era && context.era->offered.pointSprite ? &context.era->sprites : nullptr;
}

/// A mode was set that draws look at each time.
[[nodiscard]] bool mayFollowSprites(const Context &context);
/// Notes the mode of the draw that comes, outside of lists; `PointSprites::kNoPrimitive` of one
/// without.
inline void notePrimitiveMode(Context &context, GLenum mode) {
  PointSprites *const sprites = spritesOf(context);
  if (sprites && sprites->used && context.listMode == 0) [[unlikely]]
    sprites->drawn = mode;
}
/// Before the choice of what is effective: another one is made if the draw needs another form. Asks
/// the host.
void followSprites(Context &context);
/// POINT_SPRITE_R_MODE_NV; ZERO where the layer does not have it.
[[nodiscard]] inline GLenum spriteMode(const Context &context) {
  const PointSprites *const sprites = spritesOf(context);
  return sprites ? sprites->rMode : GLenum(GL_ZERO);
}
/// The form that the effective program is chosen for.
[[nodiscard]] SpriteForm spriteForm(const Context &context);
/// No form of the layer's is effective, nor a unit's COORD_REPLACE hidden from the host.
[[nodiscard]] inline bool spritesAreTheHosts(const Context &context) {
  const PointSprites *const sprites = spritesOf(context);
  return !sprites || (sprites->form.units == 0 && sprites->hidden == 0);
}
/// After the choice: the host's COORD_REPLACE is what the program of the draw needs.
void applySprites(Context &context);

/// releaseSprites(), where there are hidden units.
[[gnu::cold]] void showCoordinates(Context &context, PointSprites &sprites);
/// The host's COORD_REPLACE becomes the application's again; the next draw looks.
inline void releaseSprites(Context &context) {
  if (PointSprites *const sprites = spritesOf(context); sprites && sprites->hidden != 0)
      [[unlikely]]
    showCoordinates(context, *sprites);
}

/// PointParameter of POINT_SPRITE_R_MODE_NV, outside of lists, with its errors.
void setSpriteMode(Context &context, GLenum mode);

} // namespace arbiter::state
