// Program parameters of NV_vertex_program (2.14.1.2, 6.1.13), which are the vertex target's env
// parameters.
#include <algorithm>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/lists/list_compiler.h"
#include "state/programs/nv/matrix_tracking.h"
#include "state/programs/nv/nv_programs.h"
#include "state/programs/nv/nv_state.h"
#include "state/programs/parameters.h"

namespace arbiter::state {

namespace {

void record(Context &context, GLenum target, GLuint index, GLsizei count,
            std::vector<Vec4> values) {
  Command command{.kind = Command::Kind::ParameterNv, .target = target, .name = index};
  command.count = count;
  command.values = std::move(values);
  listCompiler(context).record(context, std::move(command));
}

/// Converts parameters of any type. If the count is an error, returns no values, because none may
/// be read then. setNvParameters() raises the error when the command is executed.
template <typename T> std::vector<Vec4> gatherParameters(GLsizei count, const T *params) {
  std::vector<Vec4> values(count > 0 && GLuint(count) <= NvState::kParameters ? std::size_t(count)
                                                                              : 0);
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t c = 0; c < 4; ++c)
      values[i][c] = GLfloat(params[4 * i + c]);
  return values;
}

/// Sets parameters, or records the command in a list.
void setParameters(Context &context, GLenum target, GLuint index, GLsizei count,
                   std::vector<Vec4> values) {
  if (!outsideBeginEnd(context, "ProgramParameter between Begin and End"))
    return;
  if (context.listMode)
    return record(context, target, index, count, std::move(values));
  setNvParameters(context, target, index, count, values.data());
}

/// Sets one parameter. It allocates nothing unless a list records it, because applications call it
/// often.
void setParameters(Context &context, GLenum target, GLuint index, const Vec4 &value) {
  if (context.insideBeginEnd || context.listMode) [[unlikely]]
    return setParameters(context, target, index, 1, {value});
  setNvParameters(context, target, index, 1, &value);
}

template <typename T>
void getParameter(Context &context, GLenum target, GLuint index, GLenum pname, T *params) {
  if (!outsideBeginEnd(context, "GetProgramParameter between Begin and End"))
    return;
  if (target != GL_VERTEX_PROGRAM_NV || pname != GL_PROGRAM_PARAMETER_NV)
    return raise(context, GL_INVALID_ENUM, "GetProgramParameter: target or pname");
  const ProgramTarget &row = context.row(Target::Vertex);
  // The target may have more env parameters than NV_vertex_program, or fewer.
  const std::size_t size = std::min<std::size_t>(NvState::kParameters, row.env.size());
  if (!isRange(context, index, 1, size, "GetProgramParameter: index"))
    return;
  refreshTrackedMatrices(context);
  if (params)
    std::copy(row.env[index].begin(), row.env[index].end(), params);
}

} // namespace

namespace handlers {

void ProgramParameter4fNV(Context &context, GLenum target, GLuint index, GLfloat x, GLfloat y,
                          GLfloat z, GLfloat w) {
  setParameters(context, target, index, {x, y, z, w});
}

void ProgramParameter4fNV(Context &context, GLenum target, GLuint index,
                          host::ParameterValues values) {
  const bool isValid = target == GL_VERTEX_PROGRAM_NV && index < NvState::kParameters;
  setParameters(context, target, index, values.readIf(isValid));
}

void ProgramParameters4fvNV(Context &context, GLenum target, GLuint index, GLsizei count,
                            const GLfloat *v) {
  setParameters(context, target, index, count, gatherParameters(count, v));
}

void ProgramParameters4dvNV(Context &context, GLenum target, GLuint index, GLsizei count,
                            const GLdouble *v) {
  setParameters(context, target, index, count, gatherParameters(count, v));
}

void GetProgramParameterfvNV(Context &context, GLenum target, GLuint index, GLenum pname,
                             GLfloat *params) {
  getParameter<GLfloat>(context, target, index, pname, params);
}

void GetProgramParameterdvNV(Context &context, GLenum target, GLuint index, GLenum pname,
                             GLdouble *params) {
  getParameter<GLdouble>(context, target, index, pname, params);
}

} // namespace handlers
} // namespace arbiter::state
