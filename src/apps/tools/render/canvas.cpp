#include "apps/tools/render/canvas.h"

#include <initializer_list>

namespace arbiter::tools {

Canvas::~Canvas() {
  if (m_framebuffer == 0)
    return;
  glDeleteFramebuffers(1, &m_framebuffer);
  glDeleteRenderbuffers(2, m_buffers);
}

bool Canvas::use(int width, int height) {
  if (m_framebuffer == 0) {
    glGenFramebuffers(1, &m_framebuffer);
    glGenRenderbuffers(2, m_buffers);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
  if (width == m_width && height == m_height)
    return true;
  constexpr GLenum kFormats[] = {GL_RGBA8, GL_DEPTH24_STENCIL8};
  for (int i = 0; i < 2; ++i) {
    glBindRenderbuffer(GL_RENDERBUFFER, m_buffers[i]);
    glRenderbufferStorage(GL_RENDERBUFFER, kFormats[i], width, height);
  }
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_buffers[0]);
  for (const GLenum attachment : {GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT})
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, m_buffers[1]);
  m_width = width;
  m_height = height;
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

} // namespace arbiter::tools
