#include "quad.h"

#include <cstddef>
#include <epoxy/gl.h>

namespace bench {

void bindTextures() {
  static bool s_done = false;
  if (s_done)
    return;
  s_done = true;
  for (int unit = 4; unit >= 0; --unit) {
    GLuint name = 0;
    unsigned char texels[16 * 16 * 4];
    for (std::size_t i = 0; i < sizeof texels; ++i)
      texels[i] = static_cast<unsigned char>(i * 37 + std::size_t(unit) * 11);
    glGenTextures(1, &name);
    glActiveTexture(GL_TEXTURE0 + GLenum(unit));
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  }
}

void drawQuad() {
  static constexpr float kCorners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  glBegin(GL_QUADS);
  for (const auto &[u, v] : kCorners) {
    glColor4f(u, v, 1 - u, 1);
    glMultiTexCoord2f(GL_TEXTURE0, u, v);
    glMultiTexCoord2f(GL_TEXTURE1, v, u);
    glVertex2f(2 * u - 1, 2 * v - 1);
  }
  glEnd();
}

} // namespace bench
