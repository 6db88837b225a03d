#include "apps/tools/draw/gl_targets.h"

namespace arbiter::tools {

namespace {

GLuint makeTexture(GLint format, GLenum layout, GLenum type, int width, int height) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, layout, type, nullptr);
  glBindTexture(GL_TEXTURE_2D, 0);
  return name;
}

} // namespace

Targets::~Targets() {
  for (const Target &target : m_targets) {
    glDeleteFramebuffers(1, &target.framebuffer);
    glDeleteTextures(1, &target.color);
    glDeleteTextures(1, &target.depth);
  }
}

std::optional<RenderError> Targets::load(const scene::Document &document) {
  for (const scene::Pass &pass : document.passes) {
    const auto &spec = document.panelOf(pass).target;
    if (!spec || find(spec->name.text) != nullptr)
      continue;
    if (epoxy_gl_version() < 30 && !epoxy_has_gl_extension("GL_ARB_framebuffer_object"))
      return RenderError{RenderError::Kind::NoGl, "this GL has no GL_ARB_framebuffer_object"};
    if (auto error = add(std::size_t(pass.panel), *spec))
      return error;
  }
  return std::nullopt;
}

std::optional<RenderError> Targets::add(std::size_t file, const scene::Target &spec) {
  const int width = int(spec.width.value), height = int(spec.height.value);
  if (m_targets.empty())
    m_outer = GLuint(query(GL_FRAMEBUFFER_BINDING));
  Target target{spec.name.text};
  target.color = makeTexture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width, height);
  target.depth =
      makeTexture(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, width, height);
  glGenFramebuffers(1, &target.framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.color, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, target.depth, 0);
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  glBindFramebuffer(GL_FRAMEBUFFER, m_outer);
  m_targets.push_back(std::move(target));
  if (status == GL_FRAMEBUFFER_COMPLETE)
    return std::nullopt;
  return RenderError{RenderError::Kind::Panel, "this GL cannot draw to a target of this size", file,
                     -1, spec.name.span};
}

const Targets::Target *Targets::find(const std::string &name) const {
  for (const Target &target : m_targets)
    if (target.name == name)
      return &target;
  return nullptr;
}

void Targets::bind(const std::string &name) const {
  if (m_targets.empty())
    return;
  const Target *const target = find(name);
  glBindFramebuffer(GL_FRAMEBUFFER, target == nullptr ? m_outer : target->framebuffer);
}

GLuint Targets::texture(const std::string &name, bool depth) const {
  const Target *const target = find(name);
  return target == nullptr ? 0 : depth ? target->depth : target->color;
}

} // namespace arbiter::tools
