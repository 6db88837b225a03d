// Program objects: Gen, Delete, Is, Bind, ProgramString and queries (3.11.1, 6.1.12).
#include <cstring>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/lists/list_compiler.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_load.h"
#include "state/programs/queries.h"
#include "state/programs/variants/drop_variants.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

void deleteProgram(Context &context, GLuint name) {
  const std::shared_ptr<ProgramObject> object = context.group->remove(name);
  if (!object)
    return;
  ProgramTarget &row = context.row(object->target);
  if (row.bound == object) {
    row.bound = context.group->defaultProgram(row.target);
    invalidateProgram(context);
  }
  auto &recent = context.recentPrograms[name % context.recentPrograms.size()];
  if (recent == object)
    recent = nullptr;
  // Other contexts may have it bound. Their linked programs are dropped when they are swept.
  const auto compiled = context.group->compiledOf(*object);
  if (compiled)
    dropVariants(context, *compiled);
}

} // namespace

namespace handlers {

void BindProgramARB(Context &context, GLenum target, GLuint program) {
  if (!outsideBeginEnd(context, "BindProgram between Begin and End"))
    return;
  ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return context.host->BindProgramARB(target, program); // raises INVALID_ENUM, or knows the
                                                          // target
  noteProgramApiUse(context);
  if (context.listMode)
    return listCompiler(context).record(
        context, {.kind = Command::Kind::BindProgram, .target = target, .name = program});
  bindProgram(context, *row, program);
}

void GenProgramsARB(Context &context, GLsizei n, GLuint *programs) {
  if (!outsideBeginEnd(context, "GenPrograms between Begin and End"))
    return;
  if (n < 0)
    return raise(context, GL_INVALID_VALUE, "GenPrograms: n is negative");
  if (!programs)
    return;
  noteProgramApiUse(context);
  for (GLsizei i = 0; i < n; ++i)
    programs[i] = context.group->takeName();
}

void DeleteProgramsARB(Context &context, GLsizei n, const GLuint *programs) {
  if (!outsideBeginEnd(context, "DeletePrograms between Begin and End"))
    return;
  if (n < 0)
    return raise(context, GL_INVALID_VALUE, "DeletePrograms: n is negative");
  if (!programs)
    return;
  for (GLsizei i = 0; i < n; ++i)
    if (programs[i] != 0)
      deleteProgram(context, programs[i]);
}

GLboolean IsProgramARB(Context &context, GLuint program) {
  if (!outsideBeginEnd(context, "IsProgram between Begin and End"))
    return GL_FALSE;
  // An object exists once its name was bound, not when Gen returned the name.
  return program != 0 && context.group->contains(program) ? GL_TRUE : GL_FALSE;
}

void ProgramStringARB(Context &context, GLenum target, GLenum format, GLsizei len,
                      const void *string) {
  if (!outsideBeginEnd(context, "ProgramString between Begin and End"))
    return;
  ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return context.host->ProgramStringARB(target, format, len, string); // raises INVALID_ENUM
  noteProgramApiUse(context);
  if (context.listMode)
    return recordProgramString(context, Command::Kind::ProgramString, *row, 0, format, len, string);
  loadProgram(context, *row->bound, format, len, string);
}

void GetProgramivARB(Context &context, GLenum target, GLenum pname, GLint *params) {
  const ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return context.host->GetProgramivARB(target, pname, params);
  if (!outsideBeginEnd(context, "GetProgramiv between Begin and End") || !params)
    return;
  if (!queryProgram(context, *row, *row->bound, pname, params))
    raise(context, GL_INVALID_ENUM, "GetProgramiv: pname");
}

void GetProgramStringARB(Context &context, GLenum target, GLenum pname, void *string) {
  const ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return context.host->GetProgramStringARB(target, pname, string);
  if (!outsideBeginEnd(context, "GetProgramString between Begin and End"))
    return;
  if (pname != GL_PROGRAM_STRING_ARB)
    return raise(context, GL_INVALID_ENUM, "GetProgramString: pname");
  const auto program = context.group->compiledOf(*row->bound);
  if (program && string)
    std::memcpy(string, program->text.data(), program->text.size()); // no terminator (6.1.12)
}

} // namespace handlers
} // namespace arbiter::state
