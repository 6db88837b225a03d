// Program objects by commands of NV_vertex_program (2.14.1.7, 2.14.1.8, 2.14.4, 6.1.13).
// GenProgramsNV, DeleteProgramsNV and IsProgramNV are the ARB's.
#include <algorithm>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/lists/list_compiler.h"
#include "state/programs/nv/nv_programs.h"
#include "state/programs/nv/nv_state.h"
#include "state/programs/program_bind.h"
#include "state/programs/queries.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Returns the object of a query. Raises an error and returns null if there is none.
std::shared_ptr<ProgramObject> queried(Context &context, GLuint id, const char *command) {
  if (!outsideBeginEnd(context, command))
    return nullptr;
  std::shared_ptr<ProgramObject> object = existingProgram(context, id);
  if (!object)
    raise(context, GL_INVALID_OPERATION, command);
  return object;
}

/// Returns PROGRAM_TARGET_NV: a program in an ARB language has the ARB's target.
GLenum targetOf(Context &context, const ProgramObject &object) {
  if (object.target != Target::Fragment)
    return infoOf(object.target).name;
  const auto compiled = context.group->compiledOf(object);
  const bool native = compiled && compiled->native.language != fp::ir::NativeLanguage::None;
  return native ? GL_FRAGMENT_PROGRAM_NV : GL_FRAGMENT_PROGRAM_ARB;
}

/// Makes a list's command that names programs.
Command namesCommand(GLsizei n, const GLuint *programs) {
  Command command{.kind = Command::Kind::RequestResident};
  command.count = n;
  if (n > 0 && programs)
    command.bytes.assign(reinterpret_cast<const char *>(programs),
                         std::size_t(n) * sizeof *programs);
  return command;
}

} // namespace

namespace handlers {

void LoadProgramNV(Context &context, GLenum target, GLuint id, GLsizei len,
                   const GLubyte *program) {
  if (!outsideBeginEnd(context, "LoadProgram between Begin and End"))
    return;
  noteProgramApiUse(context);
  if (!context.listMode)
    return loadNvProgram(context, target, id, len, program);
  Command command{.kind = Command::Kind::LoadNv, .target = target, .name = id};
  command.count = len;
  // A text over the limit is refused when executed; this much of it is enough for that.
  if (program && len > 0) {
    command.count = std::min<GLsizei>(len, GLsizei(fp::kMaxTextBytes) + 1);
    command.bytes.assign(reinterpret_cast<const char *>(program), std::size_t(command.count));
  }
  listCompiler(context).record(context, std::move(command));
}

void BindProgramNV(Context &context, GLenum target, GLuint id) {
  // Hosts without the extension still have this command, as another name of the ARB's.
  if (!context.nv)
    return BindProgramARB(context, target, id);
  if (!outsideBeginEnd(context, "BindProgram between Begin and End"))
    return;
  noteProgramApiUse(context);
  if (context.listMode)
    return listCompiler(context).record(
        context, {.kind = Command::Kind::BindNv, .target = target, .name = id});
  bindNvProgram(context, target, id);
}

void ExecuteProgramNV(Context &context, GLenum target, GLuint id, const GLfloat *params) {
  if (!outsideBeginEnd(context, "ExecuteProgram between Begin and End"))
    return;
  Vec4 input{};
  if (params)
    std::copy_n(params, 4, input.begin());
  if (!context.listMode)
    return executeStateProgram(context, target, id, input);
  Command command{.kind = Command::Kind::ExecuteNv, .target = target, .name = id};
  command.values.push_back(input);
  listCompiler(context).record(context, std::move(command));
}

GLboolean AreProgramsResidentNV(Context &context, GLsizei n, const GLuint *programs,
                                GLboolean * /*residences*/) {
  if (!outsideBeginEnd(context, "AreProgramsResident between Begin and End"))
    return GL_FALSE;
  const bool allExist =
      n >= 0 && std::all_of(programs, programs + (programs ? n : 0),
                            [&](GLuint id) { return existingProgram(context, id) != nullptr; });
  if (!allExist)
    raise(context, GL_INVALID_VALUE, "AreProgramsResident: n, or a name that is no program's");
  return allExist ? GL_TRUE : GL_FALSE; // there is no working set, and `residences` stays unchanged
}

void RequestResidentProgramsNV(Context &context, GLsizei n, const GLuint *programs) {
  if (!outsideBeginEnd(context, "RequestResidentPrograms between Begin and End"))
    return;
  if (context.listMode)
    return listCompiler(context).record(context, namesCommand(n, programs));
  if (n < 0)
    raise(context, GL_INVALID_VALUE, "RequestResidentPrograms: n is negative");
}

void GetProgramivNV(Context &context, GLuint id, GLenum pname, GLint *params) {
  const auto object = queried(context, id, "GetProgramiv: the id is no program's");
  if (!object || !params)
    return;
  const auto compiled = context.group->compiledOf(*object);
  switch (pname) {
  case GL_PROGRAM_TARGET_NV:
    *params = GLint(targetOf(context, *object));
    break;
  case GL_PROGRAM_LENGTH_NV:
    *params = compiled ? GLint(compiled->text.size()) : 0;
    break;
  case GL_PROGRAM_RESIDENT_NV:
    *params = GL_TRUE;
    break;
  default:
    raise(context, GL_INVALID_ENUM, "GetProgramiv: pname");
  }
}

void GetProgramStringNV(Context &context, GLuint id, GLenum pname, GLubyte *program) {
  const auto object = queried(context, id, "GetProgramString: the id is no program's");
  if (!object)
    return;
  if (pname != GL_PROGRAM_STRING_NV)
    return raise(context, GL_INVALID_ENUM, "GetProgramString: pname");
  const auto compiled = context.group->compiledOf(*object);
  if (compiled && program)
    std::copy(compiled->text.begin(), compiled->text.end(), program); // no terminator
}

} // namespace handlers
} // namespace arbiter::state
