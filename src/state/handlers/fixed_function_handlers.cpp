// Fog and the light model. FOG_MODE and LIGHT_MODEL_COLOR_CONTROL choose a shader variant where
// fixed function takes part. The other parameters reach the host's shader by themselves.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/host_draw/fixed_function.h"

namespace arbiter::state::handlers {

#define COMMAND(name, T, choosing)                                                                 \
  void name(Context &context, GLenum pname, T value) {                                             \
    context.host->name(pname, value);                                                              \
    if (pname == (choosing))                                                                       \
      noteFixedFunctionCommand(context);                                                           \
  }

COMMAND(Fogf, GLfloat, GL_FOG_MODE)
COMMAND(Fogi, GLint, GL_FOG_MODE)
COMMAND(Fogfv, const GLfloat *, GL_FOG_MODE)
COMMAND(Fogiv, const GLint *, GL_FOG_MODE)
COMMAND(LightModelf, GLfloat, GL_LIGHT_MODEL_COLOR_CONTROL)
COMMAND(LightModeli, GLint, GL_LIGHT_MODEL_COLOR_CONTROL)
COMMAND(LightModelfv, const GLfloat *, GL_LIGHT_MODEL_COLOR_CONTROL)
COMMAND(LightModeliv, const GLint *, GL_LIGHT_MODEL_COLOR_CONTROL)
#undef COMMAND

} // namespace arbiter::state::handlers
