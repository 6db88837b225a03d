#pragma once
#include <GL/gl.h>

#include "state/era/era_state.h"
#include "state/era/point_sprites.h"
#include "state/programs/program_context.h"

/// Emulates POINT_SPRITE_R_MODE_NV (NV_point_sprite) with values S and R on a host that always
/// replaces a unit's coordinates by (s, t, 0, 1). Points are drawn with a variant of the fragment
/// program that reads gl_PointCoord beside the vertex's coordinates. Meanwhile the host's
/// COORD_REPLACE is FALSE for these units, and fixed function is drawn as a program. The rasterizer
/// supports the mode itself.
namespace arbiter::state {

/// Returns null if the layer does not offer the extension.
[[nodiscard]] inline PointSprites *spritesOf(const ProgramContext &context) {
  return context.era && context.era->offered.pointSprite ? &context.era->sprites : nullptr;
}

/// True if a mode was set that each draw must check.
[[nodiscard]] bool mayFollowSprites(const ProgramContext &context);
/// Notes the primitive mode of the next draw, outside of lists. `PointSprites::kNoPrimitive` stands
/// for a draw without one.
inline void notePrimitiveMode(ProgramContext &context, GLenum mode) {
  PointSprites *const sprites = spritesOf(context);
  if (sprites && sprites->used && context.listMode == 0) [[unlikely]]
    sprites->drawn = mode;
}
/// Has another program chosen if the next draw needs another variant. Call it before the choice.
/// Queries the host.
void followSprites(ProgramContext &context);
/// Returns POINT_SPRITE_R_MODE_NV, or ZERO if the layer does not offer it.
[[nodiscard]] inline GLenum spriteMode(const ProgramContext &context) {
  const PointSprites *const sprites = spritesOf(context);
  return sprites ? sprites->rMode : GLenum(GL_ZERO);
}
/// Returns the variant for which the effective program is chosen.
[[nodiscard]] SpriteForm spriteForm(const ProgramContext &context);
/// True if no variant of the layer's is effective, and no unit's COORD_REPLACE is hidden from the
/// host.
[[nodiscard]] inline bool spritesAreTheHosts(const ProgramContext &context) {
  const PointSprites *const sprites = spritesOf(context);
  return !sprites || (sprites->form.units == 0 && sprites->hidden == 0);
}
/// Sets the host's COORD_REPLACE as the chosen program needs it.
void applySprites(ProgramContext &context);

/// Implements releaseSprites() when units are hidden.
[[gnu::cold]] void showCoordinates(ProgramContext &context, PointSprites &sprites);
/// Restores the application's COORD_REPLACE on the host; the next draw hides it again.
inline void releaseSprites(ProgramContext &context) {
  if (PointSprites *const sprites = spritesOf(context); sprites && sprites->hidden != 0)
      [[unlikely]]
    showCoordinates(context, *sprites);
}

/// Executes PointParameter of POINT_SPRITE_R_MODE_NV outside of lists, and raises its errors.
void setSpriteMode(ProgramContext &context, GLenum mode);

} // namespace arbiter::state
