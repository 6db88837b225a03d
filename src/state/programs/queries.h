#pragma once
#include <GL/gl.h>

namespace arbiter::state {

struct ProgramContext;
struct ProgramObject;
struct ProgramTarget;

/// Answers GetProgramiv for an object of the target. Returns false if pname is unknown.
[[nodiscard]] bool queryProgram(ProgramContext &context, const ProgramTarget &row,
                                const ProgramObject &object, GLenum pname, GLint *params);

} // namespace arbiter::state
