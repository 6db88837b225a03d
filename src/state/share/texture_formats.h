#pragma once
#include <atomic>
#include <mutex>
#include <unordered_map>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

/// The images of a share group's textures that have an internal format of NV_texture_shader. The
/// host stores them in another format. Other images have no entry.
class TextureFormats {
public:
  /// Notes the internal format of an image; 0: a format that the host supports.
  /// \param name the texture's; 0 for a default texture or a proxy
  /// \param image the target of TexImage, for instance a face of a cube map
  void set(GLuint name, GLenum image, GLint level, GLenum internalFormat);
  /// Returns the image's format of NV_texture_shader; 0 if it has a host format.
  [[nodiscard]] GLenum find(GLuint name, GLenum image, GLint level);
  /// Forgets textures. Called before the host deletes them.
  void remove(GLsizei n, const GLuint *names);
  /// True if any image has or had such a format. Until then nothing else takes the lock.
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
