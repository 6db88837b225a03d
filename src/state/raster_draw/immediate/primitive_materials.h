#pragma once
#include <GL/gl.h>

#include "state/core/context_hot.h"
#include "state/mirror/attributes.h"

/// Materials between Begin and End (OpenGL 2.1, 2.14.2). Some programs give them with each vertex,
/// and mostly the same ones again. What changes nothing is left out; parts that change are recorded
/// as attributes are, in slots of their own, and those that differ from vertex to vertex are
/// attributes of fixed function's vertices (fixed_function/). Programs of the application's that
/// read materials take those of before the primitive, which is split for them (split.h).
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

/// Of Material with these values: true where it is part of a primitive that is recorded now, or
/// changes nothing of it. The host may be asked. No error is raised.
[[nodiscard]] bool recordsMaterial(ContextHot &hot, GLenum face, GLenum pname,
                                   const GLfloat *values);

/// Slots whose values the host is to have behind the primitive (ImmediateRecorder::touched()), but
/// for those that it has.
[[nodiscard]] SlotMask slotsToSet(const Context &context);

} // namespace arbiter::state::software
