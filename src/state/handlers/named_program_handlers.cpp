// The program API by object name (EXT_direct_state_access). Its texts must not reach the host's
// parser either, and its objects are those of BindProgram.
#include <algorithm>
#include <cstring>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/lists/list_compiler.h"
#include "state/programs/parameters.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_load.h"
#include "state/programs/queries.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Sets local parameters, for all named setters.
void set(Context &context, const ProgramTarget &row, GLuint name, GLuint index, GLsizei count,
         const Vec4 *values) {
  if (!outsideBeginEnd(context, "NamedProgramLocalParameter between Begin and End"))
    return;
  if (context.listMode) {
    Command command{.kind = Command::Kind::NamedLocal,
                    .target = row.info().name,
                    .name = index,
                    .object = name};
    command.count = count;
    command.values.assign(values, values + count);
    return listCompiler(context).record(context, std::move(command));
  }
  if (const auto object = namedProgram(context, row, name))
    setLocal(context, *object, index, count, values);
}

void set(Context &context, const ProgramTarget &row, GLuint name, GLuint index, const Vec4 &value) {
  set(context, row, name, index, 1, &value);
}

template <typename T>
void getLocal(Context &context, const ProgramTarget &row, GLuint name, GLuint index, T *params) {
  if (!outsideBeginEnd(context, "GetNamedProgramLocalParameter between Begin and End"))
    return;
  const auto object = namedProgram(context, row, name);
  if (!object || !params)
    return;
  if (index >= row.limits.localParameters)
    return raise(context, GL_INVALID_VALUE, "GetNamedProgramLocalParameter: index");
  const Vec4 value = object->locals[index].load();
  std::copy(value.begin(), value.end(), params);
}

} // namespace

namespace handlers {

void NamedProgramStringEXT(Context &context, GLuint program, GLenum target, GLenum format,
                           GLsizei len, const void *string) {
  const ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return context.host->NamedProgramStringEXT(program, target, format, len, string);
  if (!outsideBeginEnd(context, "NamedProgramString between Begin and End"))
    return;
  noteProgramApiUse(context);
  if (context.listMode)
    return recordProgramString(context, Command::Kind::NamedString, *row, program, format, len,
                               string);
  if (const auto object = namedProgram(context, *row, program))
    loadProgram(context, *object, format, len, string);
}

void NamedProgramLocalParameter4fEXT(Context &context, GLuint program, GLenum target, GLuint index,
                                     GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
  const ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return context.host->NamedProgramLocalParameter4fEXT(program, target, index, x, y, z, w);
  set(context, *row, program, index, {x, y, z, w});
}

void NamedProgramLocalParameter4fEXT(Context &context, GLuint program, GLenum target, GLuint index,
                                     host::ParameterValues values) {
  const ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return values.pass(context.host->NamedProgramLocalParameter4fvEXT,
                       context.host->NamedProgramLocalParameter4dvEXT, program, target, index);
  set(context, *row, program, index, values.readIf(index < row->limits.localParameters));
}

void NamedProgramLocalParameters4fvEXT(Context &context, GLuint program, GLenum target,
                                       GLuint index, GLsizei count, const GLfloat *params) {
  const ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return context.host->NamedProgramLocalParameters4fvEXT(program, target, index, count, params);
  if (count < 0 || std::size_t(count) > row->limits.localParameters)
    return raise(context, GL_INVALID_VALUE, "NamedProgramLocalParameters: count");
  std::vector<Vec4> values(std::size_t(count), Vec4{});
  if (count > 0)
    std::memcpy(values.data(), params, values.size() * sizeof(Vec4));
  set(context, *row, program, index, count, values.data());
}

void GetNamedProgramLocalParameterfvEXT(Context &context, GLuint program, GLenum target,
                                        GLuint index, GLfloat *params) {
  const ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return context.host->GetNamedProgramLocalParameterfvEXT(program, target, index, params);
  getLocal(context, *row, program, index, params);
}

void GetNamedProgramLocalParameterdvEXT(Context &context, GLuint program, GLenum target,
                                        GLuint index, GLdouble *params) {
  const ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return context.host->GetNamedProgramLocalParameterdvEXT(program, target, index, params);
  getLocal(context, *row, program, index, params);
}

void GetNamedProgramivEXT(Context &context, GLuint program, GLenum target, GLenum pname,
                          GLint *params) {
  const ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return context.host->GetNamedProgramivEXT(program, target, pname, params);
  if (!outsideBeginEnd(context, "GetNamedProgramiv between Begin and End") || !params)
    return;
  const auto object = namedProgram(context, *row, program);
  if (!object)
    return;
  if (pname == GL_PROGRAM_BINDING_ARB) // the target's binding, not the object's
    *params = GLint(row->bound->name);
  else if (!queryProgram(context, *row, *object, pname, params))
    raise(context, GL_INVALID_ENUM, "GetNamedProgramiv: pname");
}

void GetNamedProgramStringEXT(Context &context, GLuint program, GLenum target, GLenum pname,
                              void *string) {
  const ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return context.host->GetNamedProgramStringEXT(program, target, pname, string);
  if (!outsideBeginEnd(context, "GetNamedProgramString between Begin and End"))
    return;
  const auto object = namedProgram(context, *row, program);
  if (!object)
    return;
  if (pname != GL_PROGRAM_STRING_ARB)
    return raise(context, GL_INVALID_ENUM, "GetNamedProgramString: pname");
  const auto compiled = context.group->compiledOf(*object);
  if (compiled && string)
    std::memcpy(string, compiled->text.data(), compiled->text.size());
}

} // namespace handlers
} // namespace arbiter::state
