#pragma once
#include "apps/scene/document.h"
#include "apps/scene/mesh/mesh.h"
#include "fp_compiler/ir/evaluate.h"
#include "raster.h"
#include "sample.h"

/// Runs one program of a pass by the compiler's interpreter.
namespace gallery {

namespace scene = arbiter::scene;

class Program {
public:
  /// Loads a program. Ends the process with a message if the compiler refuses the text.
  Program(const scene::Document &document, const scene::Pass &pass, int file, double seconds);

  [[nodiscard]] const ir::Program &code() const { return m_program; }
  /// Returns the value of an environment, local or state row.
  [[nodiscard]] ir::Vec4 parameter(const ir::Parameter &parameter) const;

private:
  [[nodiscard]] ir::Vec4 stateRow(const ir::StateRef &state) const;

  ir::Program m_program;
  std::vector<scene::ParameterRow> m_rows;
  scene::View m_view;
};

/// Computes a vertex by a program, or by fixed function without one.
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

  /// Sets the unit's texture; a unit without one reads zeros.
  void setTexture(unsigned unit, Texture texture);
  [[nodiscard]] std::array<bool, kVaryings> used() const;
  [[nodiscard]] bool kills() const;
  /// Returns the color before the framebuffer clamps it; nothing for a killed fragment.
  [[nodiscard]] std::optional<glm::vec4> run(const Fragment &fragment) const;

private:
  [[nodiscard]] ir::Vec4 attribute(const Fragment &fragment, const ir::Attribute &attribute) const;

  Program m_program;
  std::vector<std::optional<Texture>> m_textures;
};

} // namespace gallery
