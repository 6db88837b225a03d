#pragma once
#include <atomic>
#include <cstdint>
#include <mutex>
#include <unordered_map>

#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

/// A texture's state of APPLE_texture_range: promises and hints about the application's memory.
/// Images are copied, so nothing depends on them.
struct TextureRange {
  GLsizei length = 0; ///< bytes
  const void *pointer = nullptr;
  GLenum storageHint = GL_STORAGE_PRIVATE_APPLE;

  bool operator==(const TextureRange &) const = default;
};

/// The ranges of a share group's textures. A texture that was given no range has no entry.
class TextureRanges {
public:
  /// A texture's name, and for a default texture (name 0) its target.
  struct Key {
    GLuint name = 0;
    GLenum target = 0;
  };
  void set(Key key, const TextureRange &range);
  [[nodiscard]] TextureRange find(Key key);
  /// Forgets textures. Called before the host deletes them.
  void remove(GLsizei n, const GLuint *names);
  /// True if any texture has or had a range. Until then nothing else takes the lock.
  [[nodiscard]] bool any() const { return m_any.load(std::memory_order_relaxed); }

private:
  static std::uint64_t numberOf(Key key) {
    return key.name != 0 ? key.name : std::uint64_t(key.target) << 32;
  }
  std::mutex m_mutex;
  std::atomic<bool> m_any{false};
  std::unordered_map<std::uint64_t, TextureRange> m_ranges;
};

} // namespace arbiter::state
