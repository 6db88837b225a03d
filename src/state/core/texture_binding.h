#pragma once
#include <GL/gl.h>

namespace arbiter::state {

/// The query of what is bound to a target of CopyTexImage; 0 where there is no such target.
[[nodiscard]] GLenum bindingOf(GLenum target);

} // namespace arbiter::state
