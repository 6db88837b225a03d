#pragma once
#include <unordered_map>

#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

struct CoreContext;

/// The fences of one context, for NV_fence or APPLE_fence, which have separate names. Each is a
/// sync object of the host's. If the host has none, waiting for a fence waits for everything
/// (glFinish). The rasterizer needs no waiting: its pixels go to the host before the host's object
/// is made.
class Fences {
public:
  /// Returns an unused name. It is no fence (IsFence) until set() is called.
  [[nodiscard]] GLuint generate();
  /// Frees the name. Ignores names that do not exist.
  void remove(CoreContext &context, GLuint name);
  /// Puts a fence after all commands so far. It is signalled when they are done.
  void set(CoreContext &context, GLuint name);
  [[nodiscard]] bool isFence(GLuint name) const;
  /// True if the name was generated, set or not.
  [[nodiscard]] bool isName(GLuint name) const { return m_fences.count(name) != 0; }
  /// True if all commands before the fence are done, or if it was never set.
  [[nodiscard]] bool test(CoreContext &context, GLuint name);
  /// Waits until all commands before the fence are done.
  void finish(CoreContext &context, GLuint name);

private:
  enum class Status { Unset, Waits, Done };
  struct Fence {
    Status status = Status::Unset;
    GLsync sync = nullptr; ///< while the fence waits; null if the host has no sync objects
  };
  bool wait(CoreContext &context, Fence &fence, GLuint64 nanoseconds);
  static void drop(CoreContext &context, Fence &fence);

  std::unordered_map<GLuint, Fence> m_fences;
  GLuint m_last = 0;
};

} // namespace arbiter::state
