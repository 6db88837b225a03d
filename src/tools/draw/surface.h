#pragma once
#include <epoxy/egl.h>

namespace arbiter::tools {

/// A compatibility context that is current on a pbuffer, of a display without a window system, for
/// as long as the object lives.
class Surface {
public:
  Surface() = default;
  Surface(const Surface &) = delete;
  Surface &operator=(const Surface &) = delete;
  ~Surface();

  /// \returns the step that failed, or nullptr.
  const char *open(int width, int height);

private:
  EGLDisplay m_display = EGL_NO_DISPLAY;
};

} // namespace arbiter::tools
