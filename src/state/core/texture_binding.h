#pragma once
#include <GL/gl.h>

#include "host/host_table.h"

namespace arbiter::state {

class Context;

/// The query of what is bound to a target of CopyTexImage; 0 where there is no such target.
[[nodiscard]] GLenum bindingOf(GLenum target);

/// What other contexts may have done, or do at this moment, with names that a binding puts back.
struct NameSharing {
  /// Other contexts of the share group are there, or some were that deleted textures.
  bool others = false;
  /// What is bound here under the name may be an older object than the one that has it now.
  bool ambiguous = false;
};
/// Of the layer's own textures: of no name that an application knows.
[[nodiscard]] NameSharing sharingOf(const Context &context);

/// A texture bound to its target, and its unit active, while this lives. Where there are other
/// contexts nothing of the application's is bound away, not for a moment: another context may
/// delete its name meanwhile (OpenGL 2.1, appendix D), and to bind it anew would make another
/// object, without an image. Then this is a unit where the texture is bound already, or one where
/// nothing is.
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
  GLint m_unit = 0; ///< that was active; 0: still is
  bool m_changed = false;
};

} // namespace arbiter::state
