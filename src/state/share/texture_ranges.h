#pragma once
#include <atomic>
#include <cstdint>
#include <mutex>
#include <unordered_map>

#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

/// What APPLE_texture_range keeps of a texture: promises and hints about the application's memory.
/// Images are copied, so that nothing depends on it.
struct TextureRange {
  GLsizei length = 0; ///< bytes
  const void *pointer = nullptr;
  GLenum storageHint = GL_STORAGE_PRIVATE_APPLE;

  bool operator==(const TextureRange &) const = default;
};

/// The ranges of a share group's textures. Of one that was given none nothing is kept.
class TextureRanges {
public:
  /// A texture's name; of a default one (name 0) its target too.
  struct Key {
    GLuint name = 0;
    GLenum target = 0;
  };
  void set(Key key, const TextureRange &range);
  [[nodiscard]] TextureRange find(Key key);
  /// Before the host deletes the textures.
  void remove(GLsizei n, const GLuint *names);
  /// Some texture has one, or had: until then nothing else takes the lock.
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
