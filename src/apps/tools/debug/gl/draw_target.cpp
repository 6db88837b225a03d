#include "apps/tools/debug/gl/draw_target.h"

#include <algorithm>
#include <initializer_list>

namespace arbiter::tools::debug {

namespace {

GLuint makeBuffer(GLenum format, int width, int height, std::initializer_list<GLenum> places) {
  GLuint name = 0;
  glGenRenderbuffers(1, &name);
  glBindRenderbuffer(GL_RENDERBUFFER, name);
  glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  for (const GLenum place : places)
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, name);
  return name;
}

} // namespace

void DrawTarget::release() {
  glDeleteFramebuffers(1, &m_framebuffer);
  glDeleteRenderbuffers(1, &m_depth);
  glDeleteRenderbuffers(GLsizei(m_colors.size()), m_colors.data());
  m_colors.clear();
  m_framebuffer = 0;
}

std::string DrawTarget::bind(int width, int height, std::size_t targets) {
  if (m_width < width || m_height < height)
    release();
  if (m_framebuffer == 0) {
    m_width = std::max(m_width, width);
    m_height = std::max(m_height, height);
    glGenFramebuffers(1, &m_framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    m_depth = makeBuffer(GL_DEPTH24_STENCIL8, m_width, m_height,
                         {GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT});
  }
  glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
  while (m_colors.size() < targets)
    m_colors.push_back(
        makeBuffer(m_format, m_width, m_height, {GL_COLOR_ATTACHMENT0 + GLenum(m_colors.size())}));
  std::vector<GLenum> buffers;
  for (std::size_t i = 0; i < targets; ++i)
    buffers.push_back(GL_COLOR_ATTACHMENT0 + GLenum(i));
  glDrawBuffers(GLsizei(targets), buffers.data());
  m_drawn = targets;
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE)
    return {};
  release();
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
  std::vector<fp::ir::Vec4> values(m_drawn * pixels);
  bindToRead();
  for (std::size_t i = 0; i < m_drawn; ++i) {
    glReadBuffer(GL_COLOR_ATTACHMENT0 + GLenum(i));
    glReadPixels(region.x, region.y, region.width, region.height, GL_RGBA, GL_FLOAT,
                 values.data() + i * pixels);
  }
  return values;
}

} // namespace arbiter::tools::debug
