#pragma once
#include <epoxy/egl.h>

namespace arbiter::tools {

/// Makes a compatibility context current on a pbuffer of a display without a window system. The
/// context lives as long as the object.
class Surface {
public:
  Surface() = default;
  Surface(const Surface &) = delete;
  Surface &operator=(const Surface &) = delete;
  ~Surface();

  /// Opens the display and makes the context current.
  /// \returns the step that failed, or nullptr.
  const char *open(int width, int height);

private:
  EGLDisplay m_display = EGL_NO_DISPLAY;
};

} // namespace arbiter::tools
