#pragma once
#include <memory>
#include <vector>

/// Contexts and drawables: by EGL without a window system (many and fast) or by GLX (with windows
/// that are resized and shown). Any thread may call the functions; a context and a drawable are
/// used by one thread at a time.
namespace sharing {

struct Size {
  int width = 0, height = 0;
};

class Platform {
public:
  virtual ~Platform() = default;
  /// Creates a context. Exits the process with a message if it cannot.
  [[nodiscard]] virtual void *makeContext(void *share) = 0;
  virtual void destroyContext(void *context) = 0;
  [[nodiscard]] virtual void *makeDrawable(Size size) = 0;
  virtual void destroyDrawable(void *drawable) = 0;
  /// Makes a context current; null for both releases the thread's.
  virtual void makeCurrent(void *drawable, void *context) = 0;
  /// True if drawables are windows, which support the following three functions.
  [[nodiscard]] virtual bool hasWindows() const { return false; }
  virtual void swap(void *) {}
  virtual void resize(void *, Size) {}
  /// Returns the window's visible content, RGBA8 with an alpha of 255, bottom row first.
  [[nodiscard]] virtual std::vector<unsigned char> grab(void *, Size) { return {}; }
};

[[nodiscard]] std::unique_ptr<Platform> makeEglPlatform();
[[nodiscard]] std::unique_ptr<Platform> makeGlxPlatform();
/// Prints a message and exits with status 2.
[[noreturn]] void die(const char *what);

} // namespace sharing
