#pragma once
#include <GL/gl.h>

namespace arbiter::state {

/// What the application hinted at; nothing here depends on it.
struct Hints {
  GLenum transform = GL_DONT_CARE;         ///< APPLE_transform_hint
  GLenum multisampleFilter = GL_DONT_CARE; ///< NV_multisample_filter_hint
};

} // namespace arbiter::state
