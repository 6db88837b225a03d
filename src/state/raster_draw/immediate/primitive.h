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
/// The open primitive may be of as many vertices as its draw allows.
void limitOpen(Context &context);
/// Another primitive of the mode opens behind those that are held, in modes that are joined by
/// indices. False: there is no memory for it, and nothing has changed.
[[nodiscard]] bool openNext(Context &context);
/// Draws what is recorded, with the primitives that were held before it (held.h). Raises
/// OUT_OF_MEMORY where vertices found no memory.
void endPrimitive(Context &context);
/// The same of those alone, as no other follows.
void endHeld(Context &context);

} // namespace arbiter::state::software
