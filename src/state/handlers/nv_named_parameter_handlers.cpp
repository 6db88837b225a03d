// Named parameters of fragment programs (NV_fragment_program 3.11.1, 6.1.13).
#include <algorithm>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/lists/list_compiler.h"
#include "state/programs/nv/nv_programs.h"
#include "state/programs/nv/nv_state.h"

namespace arbiter::state {

namespace {

/// Returns the name. The length is cut to one byte more than an identifier may have, which no name
/// matches. It is empty if the length is an error.
std::string_view nameOf(GLsizei length, const GLubyte *name) {
  if (length <= 0 || !name)
    return {};
  const std::size_t most = fp::kMaxIdentifierBytes + 1;
  return {reinterpret_cast<const char *>(name), std::min(std::size_t(length), most)};
}

void setNamed(Context &context, GLuint id, GLsizei length, const GLubyte *name,
              host::ParameterValues values) {
  if (!outsideBeginEnd(context, "ProgramNamedParameter between Begin and End"))
    return;
  if (!context.listMode)
    return setNamedParameter(context, id, nameOf(length, name), values);
  Command command{.kind = Command::Kind::NamedParameterNv, .name = id};
  command.bytes = nameOf(length, name);
  command.values.push_back(values.read());
  listCompiler(context).record(context, std::move(command));
}

template <typename T>
void getNamed(Context &context, GLuint id, GLsizei length, const GLubyte *name, T *params) {
  Vec4 value{};
  if (outsideBeginEnd(context, "GetProgramNamedParameter between Begin and End") &&
      namedParameter(context, id, nameOf(length, name), value) && params)
    std::copy(value.begin(), value.end(), params);
}

} // namespace

namespace handlers {

void ProgramNamedParameter4fNV(Context &context, GLuint id, GLsizei len, const GLubyte *name,
                               GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
  const Vec4 value{x, y, z, w};
  setNamed(context, id, len, name, host::ParameterValues(value.data()));
}

void ProgramNamedParameter4fNV(Context &context, GLuint id, GLsizei len, const GLubyte *name,
                               host::ParameterValues values) {
  setNamed(context, id, len, name, values);
}

void GetProgramNamedParameterfvNV(Context &context, GLuint id, GLsizei len, const GLubyte *name,
                                  GLfloat *params) {
  getNamed<GLfloat>(context, id, len, name, params);
}

void GetProgramNamedParameterdvNV(Context &context, GLuint id, GLsizei len, const GLubyte *name,
                                  GLdouble *params) {
  getNamed<GLdouble>(context, id, len, name, params);
}

} // namespace handlers
} // namespace arbiter::state
