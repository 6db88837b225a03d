#pragma once
#include <cstddef>

#include <GL/gl.h>

#include "state/objects/target.h"

/// Sets env and local parameters. These functions check ranges, because lists are compiled without
/// checks.
namespace arbiter::state {

struct ProgramContext;
struct ProgramObject;
struct ProgramTarget;

/// True if [index, index + count) lies within `size` parameters. Otherwise raises INVALID_VALUE for
/// `command`.
[[nodiscard]] bool isRange(ProgramContext &context, GLuint index, GLsizei count, std::size_t size,
                           const char *command);
/// Sets `count` env parameters of the target from `index` on.
void setEnv(ProgramContext &context, ProgramTarget &row, GLuint index, GLsizei count,
            const Vec4 *values);
/// Sets `count` local parameters of `object` from `index` on.
void setLocal(ProgramContext &context, ProgramObject &object, GLuint index, GLsizei count,
              const Vec4 *values);

/// Notes that local parameters of `object` were set, so that draws with it look.
void noteLocalsChanged(ProgramContext &context, ProgramObject &object);

} // namespace arbiter::state
