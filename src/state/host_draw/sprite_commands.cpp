#include "state/host_draw/sprite_commands.h"

#include "state/era/era_state.h"
#include "state/host_draw/draw_context.h"
#include "state/programs/variants/point_sprites.h"

namespace arbiter::state {

namespace {

/// True if a list is being compiled in which the sprite mode may matter.
bool isInList(const DrawContext &context) {
  return context.listMode != 0 && !context.insideBeginEnd && context.era &&
         context.era->sprites.used;
}

} // namespace

void issuePrimitiveMode(DrawContext &context, GLenum mode) {
  if (context.listMode == 0)
    return notePrimitiveMode(context, mode);
  if (isInList(context) && context.list->changesKind(mode == GL_POINTS))
    context.list->record(context, {.kind = Command::Kind::PrimitiveMode, .target = mode});
}

bool recordCoordReplace(DrawContext &context, GLenum pname, GLint value) {
  if (context.executesNow())
    releaseSprites(context);
  if (!isInList(context))
    return false;
  context.list->record(
      context, {.kind = Command::Kind::CoordReplace, .target = pname, .count = GLsizei(value)});
  return true;
}

void noteSpriteCommand(DrawContext &context) {
  if (isInList(context))
    context.list->cut(context);
}

} // namespace arbiter::state
