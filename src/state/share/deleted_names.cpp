#include "state/share/deleted_names.h"

namespace arbiter::state {

void DeletedNames::add(Kind kind, GLsizei n, const GLuint *names, std::uint32_t serial) {
  if (n <= 0 || !names)
    return;
  const std::lock_guard lock(m_mutex);
  for (GLsizei i = 0; i < n; ++i) {
    if (names[i] == 0)
      continue;
    Deletion &deletion = m_deleted[{kind, names[i]}];
    deletion.others = deletion.others || (deletion.count != 0 && deletion.serial != serial);
    deletion.serial = serial;
    ++deletion.count;
  }
  m_any.store(!m_deleted.empty(), std::memory_order_relaxed);
}

bool DeletedNames::isUniqueWhereBound(Kind kind, GLuint name, std::uint32_t serial) {
  if (none())
    return true;
  const std::lock_guard lock(m_mutex);
  const auto found = m_deleted.find({kind, name});
  return found == m_deleted.end() || (!found->second.others && found->second.serial == serial);
}

void DeletedNames::attached(std::uint32_t serial, GLuint framebuffer, GLenum point, Kind kind,
                            GLuint name) {
  const std::lock_guard lock(m_mutex);
  const auto found = m_deleted.find({kind, name});
  if (found != m_deleted.end())
    m_attached[{serial, framebuffer, point}] = {kind, name, found->second.count};
}

bool DeletedNames::isAttached(std::uint32_t serial, GLuint framebuffer, GLenum point, Kind kind,
                              GLuint name) {
  if (none())
    return true;
  const std::lock_guard lock(m_mutex);
  const auto found = m_deleted.find({kind, name});
  if (found == m_deleted.end())
    return true;
  const auto attached = m_attached.find({serial, framebuffer, point});
  return attached != m_attached.end() &&
         attached->second == std::tuple{kind, name, found->second.count};
}

} // namespace arbiter::state
