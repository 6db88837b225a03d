#pragma once
#include <GL/gl.h>

/// The vertices between Begin and End, drawn when the primitive is whole; of very many, parts of
/// them before.
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

/// True if the primitive is deferred: the recorder is open, and endPrimitive() draws it, or has the
/// host draw it after all. False: the host draws, and has been brought up to date. Requires:
/// isCandidate() (decision.h), a legal mode.
[[nodiscard]] bool beginPrimitive(Context &context, GLenum mode);
/// Raises OUT_OF_MEMORY where the primitive's vertices found no memory.
void endPrimitive(Context &context);

} // namespace arbiter::state::software
