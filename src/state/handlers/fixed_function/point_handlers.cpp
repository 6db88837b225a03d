// PointParameter. POINT_SPRITE_R_MODE_NV is the layer's if it offers NV_point_sprite.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/era/era_state.h"
#include "state/lists/list_compiler.h"
#include "state/programs/program_bind.h"
#include "state/programs/variants/point_sprites.h"

namespace arbiter::state {

namespace {

/// Sets the sprite mode, if the layer implements it. Returns false if the parameter is the host's.
bool isMode(Context &context, GLenum pname, GLfloat value) {
  if (pname != GL_POINT_SPRITE_R_MODE_NV || !context.era || !context.era->offered.pointSprite)
    return false;
  if (!outsideBeginEnd(context, "PointParameter between Begin and End"))
    return true;
  const GLenum mode = value >= 0.0f && value < 65536.0f ? GLenum(value) : ~0u;
  noteProgramApiUse(context);
  context.era->sprites.used = true;
  if (context.listMode != 0)
    listCompiler(context).record(context, {.kind = Command::Kind::SpriteMode, .target = mode});
  else
    setSpriteMode(context, mode);
  return true;
}

} // namespace

namespace handlers {

void PointParameterf(Context &context, GLenum pname, GLfloat param) {
  if (!isMode(context, pname, param))
    context.host->PointParameterf(pname, param);
}
void PointParameteri(Context &context, GLenum pname, GLint param) {
  if (!isMode(context, pname, GLfloat(param)))
    context.host->PointParameteri(pname, param);
}
void PointParameterfv(Context &context, GLenum pname, const GLfloat *params) {
  if (!params || !isMode(context, pname, *params))
    context.host->PointParameterfv(pname, params);
}
void PointParameteriv(Context &context, GLenum pname, const GLint *params) {
  if (!params || !isMode(context, pname, GLfloat(*params)))
    context.host->PointParameteriv(pname, params);
}

} // namespace handlers
} // namespace arbiter::state
