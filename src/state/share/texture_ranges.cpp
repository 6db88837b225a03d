#include "state/share/texture_ranges.h"

namespace arbiter::state {

void TextureRanges::set(Key key, const TextureRange &range) {
  const bool plain = range == TextureRange{};
  if (plain && !any())
    return;
  const std::lock_guard lock(m_mutex);
  if (plain) {
    m_ranges.erase(numberOf(key));
    return;
  }
  m_ranges[numberOf(key)] = range;
  m_any.store(true, std::memory_order_relaxed);
}

TextureRange TextureRanges::find(Key key) {
  if (!any())
    return {};
  const std::lock_guard lock(m_mutex);
  const auto found = m_ranges.find(numberOf(key));
  return found == m_ranges.end() ? TextureRange{} : found->second;
}

void TextureRanges::remove(GLsizei n, const GLuint *names) {
  if (!any() || n < 0 || !names)
    return;
  const std::lock_guard lock(m_mutex);
  for (GLsizei i = 0; i < n; ++i)
    if (names[i] != 0)
      m_ranges.erase(names[i]);
}

} // namespace arbiter::state
