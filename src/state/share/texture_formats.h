#pragma once
#include <atomic>
#include <mutex>
#include <unordered_map>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

/// Which images of a share group's textures have an internal format of NV_texture_shader, for which
/// the host has another one. Of any other image nothing is kept.
class TextureFormats {
public:
  /// The image was given an internal format; 0: one that the host has itself.
  /// \param name the texture's, 0 of a default texture or a proxy
  /// \param image the target as TexImage names it: a face of a cube map
  void set(GLuint name, GLenum image, GLint level, GLenum internalFormat);
  /// 0: one of the host's.
  [[nodiscard]] GLenum find(GLuint name, GLenum image, GLint level);
  /// Before the host deletes the textures.
  void remove(GLsizei n, const GLuint *names);
  /// Some image has one, or had: until then nothing else takes the lock.
  [[nodiscard]] bool any() const { return m_any.load(std::memory_order_relaxed); }

private:
  struct Image {
    GLenum image;
    GLint level;
    GLenum format;
  };

  std::mutex m_mutex;
  std::atomic<bool> m_any{false};
  std::unordered_map<GLuint, std::vector<Image>> m_textures;
};

} // namespace arbiter::state
