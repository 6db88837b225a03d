#include "apps/tools/debug/gl/document_subject.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace arbiter::tools::debug {

namespace {

/// True if a pass tests depths that an earlier pass wrote.
bool passesMeet(const scene::Document &document) {
  for (std::size_t pass = 1; pass < document.passes.size(); ++pass)
    if (!document.clears(pass) && document.depthOf(document.passes[pass]) != scene::Depth::Off)
      return true;
  return false;
}

/// Returns "file", or "file:line:column" for a setting of a panel.
std::string placeOf(const RenderError &error, const scene::ProgramFile &file) {
  if (error.kind != RenderError::Kind::Panel)
    return file.name;
  const fp::LineColumn at = fp::locate(file.text, error.span.begin);
  return file.name + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
}

} // namespace

std::array<int, 2> DocumentSubject::size() const {
  const auto [width, height] = m_document.sizeOf(m_document.passes[m_pass]);
  return {width, height};
}

std::optional<DebugError> DocumentSubject::prepare() {
  if (const char *step = m_surface.open(m_document.width(), m_document.height()))
    return DebugError{std::string(step) + " (EGL error " + std::to_string(eglGetError()) + ")"};
  if (passesMeet(m_document)) {
    std::string fault = m_window.bind(m_document.width(), m_document.height(), 1);
    if (!fault.empty())
      return DebugError{std::move(fault)};
  }
  auto made = Renderer::make(m_document);
  if (!made) {
    const RenderError &error = made.error();
    const bool isOption = error.kind == RenderError::Kind::Panel && error.span.end == 0;
    return DebugError{(isOption ? "" : placeOf(error, m_document.files[error.file]) + ": ") +
                          error.message,
                      error.kind == RenderError::Kind::Panel};
  }
  m_renderer = std::move(made).value();
  // With feedback a frame depends on all earlier frames.
  for (int frame = 0; m_document.hasFeedback() && frame < m_frame; ++frame)
    m_renderer->draw(frame);
  m_renderer->stopBefore(m_frame, m_pass);
  return {};
}

bool DocumentSubject::clear() {
  if (!m_document.clears(m_pass))
    return false;
  m_renderer->clearTarget(m_pass);
  return true;
}

void DocumentSubject::setPlainState() {
  for (const GLenum capability :
       {GL_BLEND, GL_ALPHA_TEST, GL_DITHER, GL_COLOR_LOGIC_OP, GL_MULTISAMPLE})
    glDisable(capability);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

} // namespace arbiter::tools::debug
