#pragma once
#include <GL/gl.h>

namespace arbiter::state {

class Context;
struct ProgramObject;
struct ProgramTarget;

/// GetProgramiv on an object of the target. False: pname is not known.
[[nodiscard]] bool queryProgram(Context &context, const ProgramTarget &row,
                                const ProgramObject &object, GLenum pname, GLint *params);

} // namespace arbiter::state
