#pragma once
#include <memory>
#include <vector>

/// Contexts and what they draw to, of EGL without a window system (many and quick) or of GLX (with
/// windows that change their size and are shown). What can be called from any thread is; a context
/// and a drawable are used by one thread at a time.
namespace sharing {

struct Size {
  int width = 0, height = 0;
};

class Platform {
public:
  virtual ~Platform() = default;
  /// Exits the process, after a message, where there is none.
  [[nodiscard]] virtual void *makeContext(void *share) = 0;
  virtual void destroyContext(void *context) = 0;
  [[nodiscard]] virtual void *makeDrawable(Size size) = 0;
  virtual void destroyDrawable(void *drawable) = 0;
  /// Null for both: the calling thread has none from then on.
  virtual void makeCurrent(void *drawable, void *context) = 0;
  /// Drawables are windows: with the three that follow.
  [[nodiscard]] virtual bool hasWindows() const { return false; }
  virtual void swap(void *) {}
  virtual void resize(void *, Size) {}
  /// What the window shows, RGBA8 with an alpha of 255, bottom row first.
  [[nodiscard]] virtual std::vector<unsigned char> grab(void *, Size) { return {}; }
};

[[nodiscard]] std::unique_ptr<Platform> makeEglPlatform();
[[nodiscard]] std::unique_ptr<Platform> makeGlxPlatform();
/// A message, and the end with status 2.
[[noreturn]] void die(const char *what);

} // namespace sharing
