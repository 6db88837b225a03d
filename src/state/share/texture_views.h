#pragma once
#include <atomic>
#include <mutex>
#include <unordered_set>

#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

/// Textures of a share group that share texels (ARB_texture_view). The host cannot be asked whether
/// a texture has views, so every context notes the views it makes. Such textures have no shadow, as
/// drawing to one changes the other.
class TextureViews {
public:
  /// Notes a view. Called before the host makes `view` of the texture `original`.
  void add(GLuint view, GLuint original);
  /// Forgets names. Called before the host deletes them, as other textures may get the names then.
  /// An object that lives on under such a name has no shadow anyway (DeletedNames).
  void remove(GLsizei n, const GLuint *names);
  /// True if the texture is a view or has one.
  [[nodiscard]] bool contains(GLuint name);

private:
  std::mutex m_mutex;
  std::atomic<bool> m_any{false}; ///< false: no view was ever made, and no lock is taken
  std::unordered_set<GLuint> m_names;
};

} // namespace arbiter::state
