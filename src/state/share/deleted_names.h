#pragma once
#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <tuple>

#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

/// Names of textures and renderbuffers that a share group's contexts deleted. A host gives such a
/// name out again while the object that had it lives on: attached to a framebuffer, or bound in
/// another context. Asked what is attached, it tells that name, of either object. So code that
/// finds an object by what the host says is attached asks here which one is meant.
class DeletedNames {
public:
  enum class Kind : std::uint8_t { Texture, Renderbuffer };

  /// Before the host deletes them in context `serial`.
  void add(Kind kind, GLsizei n, const GLuint *names, std::uint32_t serial);
  /// Nothing of that name can be bound in context `serial` but what has the name now: its own
  /// deletions unbind.
  [[nodiscard]] bool isUniqueWhereBound(Kind kind, GLuint name, std::uint32_t serial);
  /// The object of that name was attached at a point of a framebuffer of context `serial`.
  void attached(std::uint32_t serial, GLuint framebuffer, GLenum point, Kind kind, GLuint name);
  /// What is attached there under that name is the object that has it now.
  [[nodiscard]] bool isAttached(std::uint32_t serial, GLuint framebuffer, GLenum point, Kind kind,
                                GLuint name);
  /// Without a lock: none was ever deleted.
  [[nodiscard]] bool none() const { return !m_any.load(std::memory_order_relaxed); }

private:
  using Key = std::tuple<Kind, GLuint>;
  struct Deletion {
    std::uint32_t count = 0;  ///< of objects that had the name
    std::uint32_t serial = 0; ///< of the context that deleted the last one
    bool others = false;      ///< and another one deleted one before
  };
  std::mutex m_mutex;
  std::atomic<bool> m_any{false};
  std::map<Key, Deletion> m_deleted;
  /// By context, framebuffer and point: the name, and its count when it was attached.
  std::map<std::tuple<std::uint32_t, GLuint, GLenum>, std::tuple<Kind, GLuint, std::uint32_t>>
      m_attached;
};

} // namespace arbiter::state
