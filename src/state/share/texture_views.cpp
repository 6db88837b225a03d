#include "state/share/texture_views.h"

namespace arbiter::state {

void TextureViews::add(GLuint view, GLuint original) {
  const std::lock_guard lock(m_mutex);
  m_any.store(true, std::memory_order_relaxed);
  for (const GLuint name : {view, original})
    if (name != 0)
      m_names.insert(name);
}

void TextureViews::remove(GLsizei n, const GLuint *names) {
  if (n <= 0 || !names || !m_any.load(std::memory_order_relaxed))
    return;
  const std::lock_guard lock(m_mutex);
  for (GLsizei i = 0; i < n; ++i)
    m_names.erase(names[i]);
}

bool TextureViews::contains(GLuint name) {
  if (!m_any.load(std::memory_order_relaxed))
    return false;
  const std::lock_guard lock(m_mutex);
  return m_names.contains(name);
}

} // namespace arbiter::state
