#pragma once
#include <GL/gl.h>

namespace arbiter::state {

/// Hints of the application. The layer keeps them and does nothing with them.
struct Hints {
  GLenum transform = GL_DONT_CARE;         ///< APPLE_transform_hint
  GLenum multisampleFilter = GL_DONT_CARE; ///< NV_multisample_filter_hint
};

} // namespace arbiter::state
