#pragma once
#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <tuple>

#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

/// Names of textures and renderbuffers that contexts of a share group deleted. A deleted object
/// lives on while it is attached to a framebuffer or bound in another context. Meanwhile the host
/// may give its name to a new object, and reports the same name for both. Code that finds an object
/// by the name that the host reports asks here which object is meant.
class DeletedNames {
public:
  enum class Kind : std::uint8_t { Texture, Renderbuffer };

  /// Notes that context `serial` is about to delete the names.
  void add(Kind kind, GLsizei n, const GLuint *names, std::uint32_t serial);
  /// True if the name, where bound in context `serial`, can only mean the object that has it now: a
  /// context's own deletions unbind.
  [[nodiscard]] bool isUniqueWhereBound(Kind kind, GLuint name, std::uint32_t serial);
  /// Notes that the object that now has the name is attached to a framebuffer of context `serial`.
  void attached(std::uint32_t serial, GLuint framebuffer, GLenum point, Kind kind, GLuint name);
  /// True if the attachment of that name is the object that has the name now.
  [[nodiscard]] bool isAttached(std::uint32_t serial, GLuint framebuffer, GLenum point, Kind kind,
                                GLuint name);
  /// True if no name was ever deleted. Takes no lock.
  [[nodiscard]] bool none() const { return !m_any.load(std::memory_order_relaxed); }

private:
  using Key = std::tuple<Kind, GLuint>;
  struct Deletion {
    std::uint32_t count = 0;  ///< of deleted objects that had the name
    std::uint32_t serial = 0; ///< of the context that deleted the last of them
    bool others = false;      ///< contexts other than `serial` deleted one too
  };
  std::mutex m_mutex;
  std::atomic<bool> m_any{false};
  std::map<Key, Deletion> m_deleted;
  /// By context, framebuffer and attachment point: the name, and its `count` when it was attached.
  std::map<std::tuple<std::uint32_t, GLuint, GLenum>, std::tuple<Kind, GLuint, std::uint32_t>>
      m_attached;
};

} // namespace arbiter::state
