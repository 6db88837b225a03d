#pragma once
#include <map>
#include <memory>

#include "apps/tools/debug/gl/draw_target.h"
#include "apps/tools/debug/gl/subject.h"
#include "apps/tools/debug/pixel/drawer.h"

namespace arbiter::tools::debug {

/// Draws a subject in the current context.
class FrameDrawer : public Drawer {
public:
  [[nodiscard]] static Result<std::unique_ptr<Drawer>, DebugError>
  open(std::unique_ptr<Subject> subject);

  [[nodiscard]] std::string name() const override;
  [[nodiscard]] std::array<int, 2> size() const override { return m_subject->size(); }
  [[nodiscard]] Result<std::vector<Vec4>, DebugError>
  draw(const std::string &text, std::size_t targets, const Region &region,
       const std::vector<Vec4> &locals = {}) override;
  [[nodiscard]] Result<std::vector<std::array<std::uint8_t, 4>>, DebugError>
  picture(const Region &region) override;
  [[nodiscard]] Result<std::array<int, 3>, DebugError>
  textureSize(unsigned unit, fp::ir::TexTarget target) override;
  [[nodiscard]] Result<Vec4, DebugError> vertexState(const fp::ir::StateRef &state) override;

private:
  explicit FrameDrawer(std::unique_ptr<Subject> subject) : m_subject(std::move(subject)) {}
  void keepProgram();
  void keepPicture();
  void keepDepths();
  std::string load(const std::string &text);
  void forgetPrograms();
  void unload();

  std::unique_ptr<Subject> m_subject;
  DrawTarget m_target;
  DrawTarget m_before;        ///< depth and stencil before the draw
  bool m_keepsTarget = false; ///< true if the draw's pass keeps the target's content
  GLuint m_document = 0;      ///< the document's program object; 0 for an ATI shader
  std::vector<std::pair<GLuint, Vec4>> m_locals; ///< its local parameters other than zero
  std::map<std::string, GLuint> m_programs;      ///< by the text of a program that shows values
  std::vector<std::array<std::uint8_t, 4>> m_picture;
};

} // namespace arbiter::tools::debug
