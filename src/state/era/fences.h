#pragma once
#include <unordered_map>

#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

class Context;

/// The fences of one context: NV_fence's, or APPLE_fence's, which have names of their own. Each is
/// a sync object of the host's where it has them; else what waits for one waits for all
/// (glFinish). Of the rasterizer a fence waits for nothing, as its pixels go to the host before the
/// host's object is made.
class Fences {
public:
  /// A name that is unused; it is no fence until set() (IsFence).
  [[nodiscard]] GLuint generate();
  /// Frees the name. What is no name is ignored.
  void remove(Context &context, GLuint name);
  /// Puts a fence behind all commands until now: its status is false until they are done.
  void set(Context &context, GLuint name);
  [[nodiscard]] bool isFence(GLuint name) const;
  /// A name that was generated, set or not.
  [[nodiscard]] bool isName(GLuint name) const { return m_fences.count(name) != 0; }
  /// Whether all commands before it are done. Never set: they are.
  [[nodiscard]] bool test(Context &context, GLuint name);
  /// Returns when they are.
  void finish(Context &context, GLuint name);

private:
  enum class Status { Unset, Waits, Done };
  struct Fence {
    Status status = Status::Unset;
    GLsync sync = nullptr; ///< the host's, while the fence waits; null where it has none
  };
  bool wait(Context &context, Fence &fence, GLuint64 nanoseconds);
  static void drop(Context &context, Fence &fence);

  std::unordered_map<GLuint, Fence> m_fences;
  GLuint m_last = 0;
};

} // namespace arbiter::state
