#pragma once
#include <cstddef>

#include <GL/gl.h>

#include "state/objects/target.h"

/// Env and local parameters. Ranges that list compilation does not check are checked here.
namespace arbiter::state {

class Context;
struct ProgramObject;
struct ProgramTarget;

/// Whether [index, index + count) lies in `size` parameters; else raises INVALID_VALUE for
/// `command`.
[[nodiscard]] bool isRange(Context &context, GLuint index, GLsizei count, std::size_t size,
                           const char *command);
/// `count` env parameters of the target from `index` on.
void setEnv(Context &context, ProgramTarget &row, GLuint index, GLsizei count, const Vec4 *values);
/// The same for the local parameters of `object`.
void setLocal(Context &context, ProgramObject &object, GLuint index, GLsizei count,
              const Vec4 *values);

/// Local parameters of `object` were set: draws with it look.
void noteLocalsChanged(Context &context, ProgramObject &object);

} // namespace arbiter::state
