#include "state/programs/variants/point_sprites.h"

#include <algorithm>

#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/core/unit_scope.h"
#include "state/mirror/dirty_bits.h"
#include "state/objects/linked_program.h"
#include "state/programs/program_bind.h"

namespace arbiter::state {

namespace {

constexpr int kMaxUnits = 8; ///< number of gl_TexCoord elements that programs read

GLenum polygonMode(const ProgramContext &context, std::size_t face) {
  GLint modes[2] = {GL_FILL, GL_FILL};
  context.host->GetIntegerv(GL_POLYGON_MODE, modes);
  return GLenum(modes[face]);
}

/// True if the draw makes points. Polygons of which only one face is drawn as points do not count,
/// because a program cannot tell the faces apart.
bool drawsPoints(const ProgramContext &context, GLenum mode) {
  if (mode < GL_TRIANGLES || mode > GL_POLYGON)
    return mode == GL_POINTS;
  return polygonMode(context, 0) == GL_POINT && polygonMode(context, 1) == GL_POINT;
}

std::uint8_t replacedUnits(const ProgramContext &context) {
  std::uint8_t units = 0;
  for (int unit = 0; unit < std::min(context.caps.maxTextureCoords, kMaxUnits); ++unit) {
    const UnitScope scope(*context.host, unsigned(unit));
    GLint replace = GL_FALSE;
    context.host->GetTexEnviv(GL_POINT_SPRITE, GL_COORD_REPLACE, &replace);
    units |= std::uint8_t((replace != GL_FALSE) << unit);
  }
  return units;
}

SpriteForm formNow(const ProgramContext &context, const PointSprites &sprites) {
  if (sprites.rMode == GL_ZERO || !drawsPoints(context, sprites.drawn) ||
      !context.host->IsEnabled(GL_POINT_SPRITE))
    return {};
  SpriteForm form;
  form.units = std::uint8_t(replacedUnits(context) | sprites.hidden);
  form.fromS = form.units != 0 && sprites.rMode == GL_S ? 1 : 0;
  return form;
}

void replaceCoordinates(const ProgramContext &context, std::uint8_t units, GLint value) {
  for (int unit = 0; unit < kMaxUnits; ++unit) {
    if ((units >> unit & 1) == 0)
      continue;
    const UnitScope scope(*context.host, unsigned(unit));
    context.host->TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, value);
  }
}

} // namespace

bool mayFollowSprites(const ProgramContext &context) {
  const PointSprites *const sprites = spritesOf(context);
  return sprites && sprites->rMode != GL_ZERO;
}

void followSprites(ProgramContext &context) {
  PointSprites *const sprites = spritesOf(context);
  if (!sprites || (sprites->rMode == GL_ZERO && sprites->form.units == 0)) [[likely]]
    return;
  const SpriteForm form = formNow(context, *sprites);
  if (form == sprites->form)
    return;
  sprites->form = form;
  invalidateProgram(context);
}

SpriteForm spriteForm(const ProgramContext &context) {
  const PointSprites *const sprites = spritesOf(context);
  return sprites ? sprites->form : SpriteForm{};
}

void applySprites(ProgramContext &context) {
  PointSprites *const sprites = spritesOf(context);
  if (!sprites || (sprites->form.units == 0 && sprites->hidden == 0)) [[likely]]
    return;
  const bool draws = context.effective.path == Path::HostGlsl && context.effective.linkedProgram &&
                     context.effective.linkedProgram->fragment.compiled && sprites->form.units != 0;
  if (!draws)
    return releaseSprites(context);
  const auto more = std::uint8_t(sprites->form.units & ~sprites->hidden);
  sprites->hidden |= more;
  replaceCoordinates(context, more, GL_FALSE);
}

void showCoordinates(ProgramContext &context, PointSprites &sprites) {
  replaceCoordinates(context, sprites.hidden, GL_TRUE);
  sprites.hidden = 0;
}

void setSpriteMode(ProgramContext &context, GLenum mode) {
  if (mode != GL_ZERO && mode != GL_S && mode != GL_R)
    return raise(context, GL_INVALID_ENUM, "PointParameter: POINT_SPRITE_R_MODE_NV");
  PointSprites &sprites = *spritesOf(context);
  if (sprites.rMode == mode)
    return;
  releaseSprites(context);
  sprites.rMode = mode;
  sprites.used = true;
  context.dirty |= dirty::kRaster;
  invalidateProgram(context); // makes draws look from now on
}

} // namespace arbiter::state
