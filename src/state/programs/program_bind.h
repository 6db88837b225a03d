#pragma once
#include <memory>

#include <GL/gl.h>

#include "state/objects/program_object.h"

/// Binds and enables program objects. These functions execute a command, whether it was called or
/// is replayed from a display list.
namespace arbiter::state {

struct ProgramContext;
struct ProgramTarget;

/// Notes that the share group uses a program target. Display lists are split into segments from now
/// on.
void noteProgramApiUse(ProgramContext &context);

/// Returns the object of that name and target, created at first use as BindProgram would
/// (EXT_direct_state_access). Returns null after an error.
[[nodiscard]] std::shared_ptr<ProgramObject> namedProgram(ProgramContext &context,
                                                          const ProgramTarget &row, GLuint name,
                                                          Existence existence = Existence::Now);
/// Executes BindProgram (2.14.7 of ARB_vertex_program), which creates `name` at first use.
void bindProgram(ProgramContext &context, ProgramTarget &row, GLuint name,
                 Existence existence = Existence::Now);
/// Executes Enable or Disable of the target.
void setEnabled(ProgramContext &context, ProgramTarget &row, bool enabled);

} // namespace arbiter::state
