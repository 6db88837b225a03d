#pragma once
#include <vector>

#include <epoxy/gl.h>

#include "fp_compiler/testing/vertex_shader/random_shader.h"

/// Issues a random shader by the commands of EXT_vertex_shader.
namespace vertex_shaders {

/// A shader in the application's view: its names and their kinds.
class Issued {
public:
  /// Generates its symbols and defines the shader, which stays bound.
  explicit Issued(const arbiter::fp::testing::RandomVertexShader &made);
  ~Issued();
  Issued(const Issued &) = delete;
  Issued &operator=(const Issued &) = delete;

  /// Sets GL's state, invariants and attributes. Variants are current values, or arrays of one
  /// vertex that draw() enables.
  void setValues(bool arrays);
  /// Draws one point.
  void draw() const;

private:
  [[nodiscard]] GLuint bindState(const arbiter::fp::vertex_shader::Symbol &symbol) const;
  [[nodiscard]] GLuint nameOf(const arbiter::fp::vertex_shader::Symbol &symbol) const;
  void generate();
  void define() const;
  void issue(const arbiter::fp::vertex_shader::Operation &operation) const;
  [[nodiscard]] GLuint nameOf(const arbiter::fp::vertex_shader::Result &result) const;
  [[nodiscard]] bool isVariant(std::size_t symbol) const;
  void setState(const arbiter::fp::vertex_shader::Symbol &symbol, const GLfloat *v) const;
  void setAttribute(std::size_t symbol);

  const arbiter::fp::testing::RandomVertexShader &m_made;
  GLuint m_shader = 0;
  std::vector<GLuint> m_names; ///< of the symbols
  std::vector<std::array<GLfloat, 16>> m_values;
  bool m_arrays = false;
};

} // namespace vertex_shaders
