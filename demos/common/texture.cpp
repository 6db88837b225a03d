#include "common/texture.h"

namespace demos {

Texture::~Texture() {
  if (m_name)
    glDeleteTextures(1, &m_name);
}

void Texture::begin(GLenum target, Filter filter, Wrap wrap) {
  if (!m_name)
    glGenTextures(1, &m_name);
  m_target = target;
  const GLint sampling = filter == Filter::Linear ? GL_LINEAR : GL_NEAREST;
  const GLint edge = wrap == Wrap::Repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  glBindTexture(target, m_name);
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, sampling);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, sampling);
  glTexParameteri(target, GL_TEXTURE_WRAP_S, edge);
  glTexParameteri(target, GL_TEXTURE_WRAP_T, edge);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

void Texture::create2d(const Image &image, Filter filter, Wrap wrap) {
  begin(GL_TEXTURE_2D, filter, wrap);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               image.bytes.data());
}

void Texture::create2dPairs16(int width, int height, const std::vector<std::uint16_t> &redGreen) {
  begin(GL_TEXTURE_2D, Filter::Nearest, Wrap::Clamp);
  std::vector<std::uint16_t> texels(4ull * width * height);
  for (std::size_t i = 0; i < texels.size() / 4; ++i) {
    texels[4 * i] = redGreen[2 * i];
    texels[4 * i + 1] = redGreen[2 * i + 1];
    texels[4 * i + 3] = 65535;
  }
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16, width, height, 0, GL_RGBA, GL_UNSIGNED_SHORT,
               texels.data());
}

void Texture::create1d(const Image &row, Filter filter) {
  begin(GL_TEXTURE_1D, filter, Wrap::Clamp);
  glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, row.width, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               row.bytes.data());
}

void Texture::bind(GLuint unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(m_target, m_name);
}

void Texture::copyFromFramebuffer(GLuint unit, int width, int height) const {
  bind(unit);
  glCopyTexSubImage2D(m_target, 0, 0, 0, 0, 0, width, height);
}

} // namespace demos
