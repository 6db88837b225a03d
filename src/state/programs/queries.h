#pragma once
#include <GL/gl.h>

namespace arbiter::state {

class Context;
struct ProgramObject;
struct ProgramTarget;

/// Answers GetProgramiv for an object of the target. Returns false if pname is unknown.
[[nodiscard]] bool queryProgram(Context &context, const ProgramTarget &row,
                                const ProgramObject &object, GLenum pname, GLint *params);

} // namespace arbiter::state
