// Fog and the light model: parameters that choose a shader variant where fixed function takes part.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/core/context.h"
#include "state/host_draw/fixed_function.h"

namespace arbiter::state::handlers {

// FOG_MODE and LIGHT_MODEL_COLOR_CONTROL choose a variant. The other parameters reach the host's
// shader by themselves.

void Fogf(Context &context, GLenum pname, GLfloat param) {
  context.host->Fogf(pname, param);
  if (pname == GL_FOG_MODE)
    noteFixedFunctionCommand(context);
}

void Fogi(Context &context, GLenum pname, GLint param) {
  context.host->Fogi(pname, param);
  if (pname == GL_FOG_MODE)
    noteFixedFunctionCommand(context);
}

void Fogfv(Context &context, GLenum pname, const GLfloat *params) {
  context.host->Fogfv(pname, params);
  if (pname == GL_FOG_MODE)
    noteFixedFunctionCommand(context);
}

void Fogiv(Context &context, GLenum pname, const GLint *params) {
  context.host->Fogiv(pname, params);
  if (pname == GL_FOG_MODE)
    noteFixedFunctionCommand(context);
}

void LightModelf(Context &context, GLenum pname, GLfloat param) {
  context.host->LightModelf(pname, param);
  if (pname == GL_LIGHT_MODEL_COLOR_CONTROL)
    noteFixedFunctionCommand(context);
}

void LightModeli(Context &context, GLenum pname, GLint param) {
  context.host->LightModeli(pname, param);
  if (pname == GL_LIGHT_MODEL_COLOR_CONTROL)
    noteFixedFunctionCommand(context);
}

void LightModelfv(Context &context, GLenum pname, const GLfloat *params) {
  context.host->LightModelfv(pname, params);
  if (pname == GL_LIGHT_MODEL_COLOR_CONTROL)
    noteFixedFunctionCommand(context);
}

void LightModeliv(Context &context, GLenum pname, const GLint *params) {
  context.host->LightModeliv(pname, params);
  if (pname == GL_LIGHT_MODEL_COLOR_CONTROL)
    noteFixedFunctionCommand(context);
}

} // namespace arbiter::state::handlers
