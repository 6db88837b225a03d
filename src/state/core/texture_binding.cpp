#include "state/core/texture_binding.h"

#include <algorithm>

#include "state/capabilities/host_integer.h"
#include "state/core/core_context.h"
#include "state/share/share_group.h"

#include <GL/glext.h>

namespace arbiter::state {

namespace {

constexpr GLint kDrawnFrom = 32;

} // namespace

GLenum bindingOf(GLenum target) {
  switch (target) {
  case GL_TEXTURE_1D:
    return GL_TEXTURE_BINDING_1D;
  case GL_TEXTURE_2D:
    return GL_TEXTURE_BINDING_2D;
  case GL_TEXTURE_3D:
    return GL_TEXTURE_BINDING_3D;
  case GL_TEXTURE_RECTANGLE:
    return GL_TEXTURE_BINDING_RECTANGLE;
  default:
    return target >= GL_TEXTURE_CUBE_MAP_POSITIVE_X && target <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z
               ? GL_TEXTURE_BINDING_CUBE_MAP
               : 0;
  }
}

NameSharing sharingOf(const CoreContext &context) {
  const ShareGroup &group = *context.group;
  return {group.contexts.load(std::memory_order_relaxed) > 1 || !group.deletedNames.none()};
}

TextureBinding::TextureBinding(const host::HostTable &host, GLenum target, GLuint name,
                               NameSharing sharing)
    : m_host(host), m_target(target),
      m_query(target == GL_TEXTURE_CUBE_MAP ? GLenum(GL_TEXTURE_BINDING_CUBE_MAP)
                                            : bindingOf(target)) {
  m_previous = bound();
  if (m_previous == name && !sharing.ambiguous)
    return;
  if (sharing.others && m_previous != 0) {
    m_unit = hostInteger(m_host, GL_ACTIVE_TEXTURE);
    const GLint all = hostInteger(m_host, GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    // A texture that a draw samples is bound to one of the first units.
    if (!sharing.ambiguous &&
        findUnit(std::min(all, kDrawnFrom), [&](GLuint there) { return there == name; }))
      return;
    static_cast<void>(findUnit(all, [](GLuint there) { return there == 0; }));
  }
  m_changed = m_previous != name;
  if (m_changed)
    m_host.BindTexture(m_target, name);
}

TextureBinding::~TextureBinding() {
  if (m_changed)
    m_host.BindTexture(m_target, m_previous);
  if (m_unit != 0)
    m_host.ActiveTexture(GLenum(m_unit));
}

/// Makes a unit active whose bound texture is `wanted`, searching from the last unit. Returns false
/// if there is none, which leaves the first unit active.
template <typename Wanted> bool TextureBinding::findUnit(GLint units, Wanted wanted) {
  for (GLint unit = units; unit-- > 0;) {
    m_host.ActiveTexture(GLenum(GL_TEXTURE0 + unit));
    m_previous = bound();
    if (wanted(m_previous))
      return true;
  }
  return false;
}

GLuint TextureBinding::bound() const { return GLuint(hostInteger(m_host, m_query)); }

} // namespace arbiter::state
