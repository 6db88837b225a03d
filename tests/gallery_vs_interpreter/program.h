#pragma once
#include "fp_compiler/ir/evaluate.h"
#include "raster.h"
#include "sample.h"
#include "scene/document.h"
#include "scene/mesh/mesh.h"

/// One program of a pass, run by the compiler's interpreter.
namespace gallery {

namespace scene = arbiter::scene;

class Program {
public:
  /// Ends the process with a message if the compiler refuses the text.
  Program(const scene::Document &document, const scene::Pass &pass, int file, double seconds);

  [[nodiscard]] const ir::Program &code() const { return m_program; }
  /// Values of environment, local and state rows.
  [[nodiscard]] ir::Vec4 parameter(const ir::Parameter &parameter) const;

private:
  [[nodiscard]] ir::Vec4 stateRow(const ir::StateRef &state) const;

  ir::Program m_program;
  std::vector<scene::ParameterRow> m_rows;
  scene::View m_view;
};

/// What the vertex stage makes of a vertex: a program's results, or fixed function's without one.
class VertexStage {
public:
  VertexStage(const scene::Document &document, const scene::Pass &pass, double seconds);
  [[nodiscard]] Vertex run(const scene::MeshVertex &vertex) const;

private:
  [[nodiscard]] glm::vec4 coordinate(const scene::MeshVertex &vertex, unsigned set) const;
  [[nodiscard]] ir::Vec4 attribute(const scene::MeshVertex &vertex,
                                   const ir::Attribute &attribute) const;

  const scene::Panel &m_panel;
  std::optional<Program> m_program;
  glm::mat4 m_toClip;
};

class FragmentStage {
public:
  FragmentStage(const scene::Document &document, const scene::Pass &pass, double seconds);

  /// The unit's texture; the stage reads zeros where there is none.
  void setTexture(unsigned unit, Texture texture);
  [[nodiscard]] std::array<bool, kVaryings> used() const;
  [[nodiscard]] bool kills() const;
  /// The colour before the framebuffer clamps it; nothing of a fragment that was killed.
  [[nodiscard]] std::optional<glm::vec4> run(const Fragment &fragment) const;

private:
  [[nodiscard]] ir::Vec4 attribute(const Fragment &fragment, const ir::Attribute &attribute) const;

  Program m_program;
  std::vector<std::optional<Texture>> m_textures;
};

} // namespace gallery
