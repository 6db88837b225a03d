#include "state/share/texture_formats.h"

#include <algorithm>

namespace arbiter::state {

void TextureFormats::set(GLuint name, GLenum image, GLint level, GLenum internalFormat) {
  if (internalFormat == 0 && !any())
    return;
  const std::lock_guard lock(m_mutex);
  const auto texture = m_textures.find(name);
  if (texture == m_textures.end()) {
    if (internalFormat == 0)
      return;
    m_textures[name].push_back({image, level, internalFormat});
    m_any.store(true, std::memory_order_relaxed);
    return;
  }
  std::vector<Image> &images = texture->second;
  const auto found = std::find_if(images.begin(), images.end(), [&](const Image &known) {
    return known.image == image && known.level == level;
  });
  if (found == images.end())
    images.push_back({image, level, internalFormat});
  else
    found->format = internalFormat;
}

GLenum TextureFormats::find(GLuint name, GLenum image, GLint level) {
  if (!any())
    return 0;
  const std::lock_guard lock(m_mutex);
  const auto texture = m_textures.find(name);
  if (texture == m_textures.end())
    return 0;
  GLenum ofFirst = 0; // levels that GenerateMipmap made have level 0's format
  for (const Image &known : texture->second) {
    if (known.image != image)
      continue;
    if (known.level == level)
      return known.format;
    if (known.level == 0)
      ofFirst = known.format;
  }
  return ofFirst;
}

void TextureFormats::remove(GLsizei n, const GLuint *names) {
  if (!any() || n < 0 || !names)
    return;
  const std::lock_guard lock(m_mutex);
  for (GLsizei i = 0; i < n; ++i)
    if (names[i] != 0)
      m_textures.erase(names[i]);
}

} // namespace arbiter::state
