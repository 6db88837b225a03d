#pragma once
#include <memory>

#include <GL/gl.h>

#include "state/objects/program_object.h"

/// Which program objects are bound and enabled, below the entry points: what runs when a command is
/// executed, be it called or replayed from a display list.
namespace arbiter::state {

class Context;
struct ProgramTarget;

/// Marks that the share group uses a program target: display lists are divided into segments from
/// now on.
void noteProgramApiUse(Context &context);

/// The object of that name and target, made at first use as BindProgram would
/// (EXT_direct_state_access); null after an error.
[[nodiscard]] std::shared_ptr<ProgramObject> namedProgram(Context &context,
                                                          const ProgramTarget &row, GLuint name,
                                                          Existence existence = Existence::Now);
/// BindProgram (2.14.7 of ARB_vertex_program): `name` is made at first use.
void bindProgram(Context &context, ProgramTarget &row, GLuint name,
                 Existence existence = Existence::Now);
/// Enable or Disable of the target.
void setEnabled(Context &context, ProgramTarget &row, bool enabled);

} // namespace arbiter::state
