#include "tools/debug/gl/draw_target.h"

#include <algorithm>

namespace arbiter::tools::debug {

void DrawTarget::release() {
  glDeleteFramebuffers(1, &m_framebuffer);
  glDeleteRenderbuffers(1, &m_depth);
  glDeleteRenderbuffers(GLsizei(m_colors.size()), m_colors.data());
  m_colors.clear();
}

std::string DrawTarget::bind(int width, int height, std::size_t targets) {
  if (m_width >= width && m_height >= height && m_colors.size() == targets) {
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    return {};
  }
  release();
  m_width = width;
  m_height = height;
  m_colors.resize(targets);
  glGenFramebuffers(1, &m_framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
  glGenRenderbuffers(GLsizei(targets), m_colors.data());
  std::vector<GLenum> buffers;
  for (std::size_t i = 0; i < targets; ++i) {
    buffers.push_back(GL_COLOR_ATTACHMENT0 + GLenum(i));
    glBindRenderbuffer(GL_RENDERBUFFER, m_colors[i]);
    glRenderbufferStorage(GL_RENDERBUFFER, m_format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, buffers[i], GL_RENDERBUFFER, m_colors[i]);
  }
  glGenRenderbuffers(1, &m_depth);
  glBindRenderbuffer(GL_RENDERBUFFER, m_depth);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_RENDERBUFFER, m_depth);
  glDrawBuffers(GLsizei(targets), buffers.data());
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE)
    return {};
  m_width = 0;
  return "this GL has no framebuffer of " + std::to_string(targets) +
         (m_format == GL_RGBA32F ? " float colours, " : " colours, ") + std::to_string(width) +
         "x" + std::to_string(height);
}

void DrawTarget::clear() const {
  GLfloat before[4];
  glGetFloatv(GL_COLOR_CLEAR_VALUE, before);
  const fp::ir::Vec4 value = uncovered();
  glClearColor(value[0], value[1], value[2], value[3]);
  glClear(GL_COLOR_BUFFER_BIT);
  glClearColor(before[0], before[1], before[2], before[3]);
}

std::vector<fp::ir::Vec4> DrawTarget::read(const Region &region) const {
  const auto pixels = std::size_t(region.width) * std::size_t(region.height);
  std::vector<fp::ir::Vec4> values(m_colors.size() * pixels);
  bindToRead();
  for (std::size_t i = 0; i < m_colors.size(); ++i) {
    glReadBuffer(GL_COLOR_ATTACHMENT0 + GLenum(i));
    glReadPixels(region.x, region.y, region.width, region.height, GL_RGBA, GL_FLOAT,
                 values.data() + i * pixels);
  }
  return values;
}

} // namespace arbiter::tools::debug
