#pragma once
#include <atomic>
#include <mutex>
#include <unordered_set>

#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

/// Textures of a share group that have texels in common (ARB_texture_view). A host does not say of
/// a texture that another one is a view of it, so what makes views is noted, in whichever context.
/// Such textures have no shadow: what is drawn to one is seen in the other.
class TextureViews {
public:
  /// Before the host makes `view` of the texture `original`.
  void add(GLuint view, GLuint original);
  /// Before the host deletes them: other textures may have the names then. What lives on under one
  /// of them has no shadow anyway (DeletedNames).
  void remove(GLsizei n, const GLuint *names);
  /// The texture of that name is a view, or one was made of it.
  [[nodiscard]] bool contains(GLuint name);

private:
  std::mutex m_mutex;
  std::atomic<bool> m_any{false}; ///< none was ever made: no lock is taken
  std::unordered_set<GLuint> m_names;
};

} // namespace arbiter::state
