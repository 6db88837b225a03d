#pragma once

namespace arbiter::state {

/// Before an EGLImage is made of an object of GL's, or of memory of other interfaces: from then on
/// pixels may change by commands of any context, API or process, none of which the layer sees
/// (GL_OES_EGL_image). Draws of all contexts are the host's for the rest of the process.
void imagesEscape();

} // namespace arbiter::state
