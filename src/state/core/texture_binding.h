#pragma once
#include <GL/gl.h>

#include "host/host_table.h"

namespace arbiter::state {

struct CoreContext;

/// Returns the query for the binding of a CopyTexImage target; 0 if there is no such target.
[[nodiscard]] GLenum bindingOf(GLenum target);

/// Tells whether other contexts may interfere with names that a binding restores.
struct NameSharing {
  /// The share group has other contexts, or had some that deleted textures.
  bool others = false;
  /// The object that is bound under the name may be older than the one that has the name now.
  bool ambiguous = false;
};
/// Returns the sharing for the layer's own textures, whose names no application knows.
[[nodiscard]] NameSharing sharingOf(const CoreContext &context);

/// Binds a texture and makes its unit active, while it lives. If there are other contexts, it never
/// unbinds a texture of the application's: another context may delete its name meanwhile (OpenGL
/// 2.1, appendix D), and binding the name again would make a new, empty object. It then uses a unit
/// where the texture is bound already, or one where nothing is.
class TextureBinding {
public:
  TextureBinding(const host::HostTable &host, GLenum target, GLuint name, NameSharing sharing);
  ~TextureBinding();
  TextureBinding(const TextureBinding &) = delete;
  TextureBinding &operator=(const TextureBinding &) = delete;

private:
  template <typename Wanted> bool findUnit(GLint units, Wanted wanted);
  [[nodiscard]] GLuint bound() const;

  const host::HostTable &m_host;
  GLenum m_target, m_query;
  GLuint m_previous = 0;
  GLint m_unit = 0; ///< the previously active unit; 0: unchanged
  bool m_changed = false;
};

} // namespace arbiter::state
