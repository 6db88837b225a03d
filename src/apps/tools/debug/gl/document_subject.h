#pragma once
#include <memory>

#include "apps/scene/document.h"
#include "apps/tools/debug/gl/draw_target.h"
#include "apps/tools/debug/gl/subject.h"
#include "apps/tools/draw/renderer.h"
#include "apps/tools/draw/surface.h"

namespace arbiter::tools::debug {

/// One pass of one frame of a document. If passes test each other's depths, they are drawn into a
/// framebuffer object in place of the window, like the probes of a pixel. A window's rows are
/// stored in the opposite order, so that the last bits of its depths and colors can differ.
class DocumentSubject : public Subject {
public:
  /// \param pass from 0
  /// \param frame from 0
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
  Surface m_surface; ///< must outlive the renderer
  DrawTarget m_window{GL_RGBA8};
  std::unique_ptr<Renderer> m_renderer;
};

} // namespace arbiter::tools::debug
