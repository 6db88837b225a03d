#pragma once
#include <GL/gl.h>

#include "state/core/context_hot.h"
#include "state/mirror/attributes.h"

/// Handles glMaterial between Begin and End (OpenGL 2.1, 2.14.2). Some programs call it for each
/// vertex, mostly without a change. Calls without effect are dropped. Changed parts are recorded
/// like attributes, in slots of their own. Those that differ between vertices become attributes of
/// fixed function's vertices (fixed_function/). Programs of the application that read materials use
/// those of before the primitive, so the primitive is split for them (split.h).
namespace arbiter::state {
struct RasterContext;
}

namespace arbiter::state {

/// Records a glMaterial in the recorded primitive. Returns true if that is done, or if nothing
/// would change. It may query the host. It raises no error.
[[nodiscard]] bool recordsMaterial(ContextHot &hot, GLenum face, GLenum pname,
                                   const GLfloat *values);

/// Returns the slots that the host must be given after the primitive
/// (ImmediateRecorder::touched()), without those that it already has.
[[nodiscard]] SlotMask slotsToSet(const RasterContext &context);

} // namespace arbiter::state
