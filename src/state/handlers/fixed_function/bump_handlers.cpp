// TexBumpParameter of ATI_envmap_bumpmap, if the layer implements it.
#include <cmath>
#include <type_traits>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/lists/list_compiler.h"
#include "state/programs/program_bind.h"
#include "state/programs/texture_shaders/texture_shader_commands.h"
#include "state/programs/texture_shaders/texture_shader_state.h"

namespace arbiter::state {

namespace {

using fp::texture_shader::Row;

/// Converts an integer to [-1, 1], as for colours (OpenGL 1.4, table 2.6). toInteger() does the
/// reverse.
GLfloat fromInteger(GLint value) { return GLfloat((2.0 * double(value) + 1.0) / 4294967295.0); }
GLint toInteger(GLfloat value) {
  const double wide = (double(value) * 4294967295.0 - 1.0) / 2.0;
  return wide >= 2147483647.0    ? 2147483647
         : wide <= -2147483648.0 ? -2147483647 - 1
                                 : GLint(std::lround(wide));
}

template <typename T> void set(Context &context, GLenum pname, const T *param) {
  if (!outsideBeginEnd(context, "TexBumpParameter between Begin and End"))
    return;
  if (pname != GL_BUMP_ROT_MATRIX_ATI || !param)
    return raise(context, GL_INVALID_ENUM, "TexBumpParameter: pname");
  TextureShaderCommand command{.kind = TextureShaderCommand::Kind::BumpMatrix, .pname = pname};
  for (std::size_t i = 0; i < 4; ++i)
    if constexpr (std::is_integral_v<T>)
      command.values[i] = fromInteger(param[i]);
    else
      command.values[i] = param[i];
  keepTextures(context).used = true;
  noteProgramApiUse(context);
  if (context.listMode)
    return listCompiler(context).record(
        context, {.kind = Command::Kind::TextureShaders, .bytes = bytesOf(command)});
  executeTextureShaderCommand(context, command);
}

template <typename T> void getBump(Context &context, GLenum pname, T *param) {
  if (!outsideBeginEnd(context, "GetTexBumpParameter between Begin and End") || !param)
    return;
  const TextureShaderState &state = keepTextures(context);
  switch (pname) {
  case GL_BUMP_ROT_MATRIX_SIZE_ATI:
    *param = T(4);
    return;
  case GL_BUMP_NUM_TEX_UNITS_ATI:
    *param = T(state.units());
    return;
  case GL_BUMP_TEX_UNITS_ATI:
    for (int unit = 0; unit < state.units(); ++unit)
      param[unit] = T(GL_TEXTURE0 + unit);
    return;
  case GL_BUMP_ROT_MATRIX_ATI:
    break;
  default:
    return raise(context, GL_INVALID_ENUM, "GetTexBumpParameter: pname");
  }
  const GLuint unit = activeUnit(context);
  if (unit >= GLuint(state.units()))
    return raise(context, GL_INVALID_OPERATION,
                 "GetTexBumpParameter: the active unit has no texture");
  const Vec4 &matrix = state.now().rows[unit][std::size_t(Row::Bump)];
  for (std::size_t i = 0; i < 4; ++i)
    if constexpr (std::is_integral_v<T>)
      param[i] = toInteger(matrix[i]);
    else
      param[i] = matrix[i];
}

} // namespace

namespace handlers {

void TexBumpParameterfvATI(Context &context, GLenum pname, const GLfloat *param) {
  set(context, pname, param);
}
void TexBumpParameterivATI(Context &context, GLenum pname, const GLint *param) {
  set(context, pname, param);
}
void GetTexBumpParameterfvATI(Context &context, GLenum pname, GLfloat *param) {
  getBump(context, pname, param);
}
void GetTexBumpParameterivATI(Context &context, GLenum pname, GLint *param) {
  getBump(context, pname, param);
}

} // namespace handlers
} // namespace arbiter::state
