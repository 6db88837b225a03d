#pragma once
#include <memory>

#include "scene/document.h"
#include "tools/debug/gl/draw_target.h"
#include "tools/debug/gl/subject.h"
#include "tools/draw/renderer.h"
#include "tools/draw/surface.h"

namespace arbiter::tools::debug {

/// One pass of one frame of a document. Where its passes test each other's depths they are drawn to
/// a framebuffer object that stands for the window: the probes of a pixel are drawn to one, and in
/// a window, whose rows lie the other way up in memory, depths and colours have other last bits.
class DocumentSubject : public Subject {
public:
  /// \param pass from 0 \param frame from 0
  DocumentSubject(scene::Document document, std::size_t pass, int frame)
      : m_document(std::move(document)), m_pass(pass), m_frame(frame) {}

  [[nodiscard]] std::array<int, 2> size() const override;
  [[nodiscard]] std::optional<DebugError> prepare() override;
  void drawMesh() override { m_renderer->drawMesh(m_pass); }
  bool clear() override;
  void setPlainState() override;

private:
  const scene::Document m_document;
  const std::size_t m_pass;
  const int m_frame;
  Surface m_surface; ///< outlives the renderer
  DrawTarget m_window{GL_RGBA8};
  std::unique_ptr<Renderer> m_renderer;
};

} // namespace arbiter::tools::debug
