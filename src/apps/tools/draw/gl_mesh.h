#pragma once
#include <epoxy/gl.h>

#include "apps/scene/document.h"
#include "apps/scene/mesh/mesh.h"

namespace arbiter::tools {

/// A pass's mesh in buffer objects, with all attributes that a program may read.
class GlMesh {
public:
  /// \param attribs numbers of generic attributes that a panel sets
  GlMesh(const scene::Mesh &mesh, const std::vector<scene::CoordinateSpec> &coordinates,
         bool vertexProgram, const std::vector<unsigned> &attribs);
  GlMesh(const GlMesh &) = delete;
  GlMesh &operator=(const GlMesh &) = delete;
  ~GlMesh();

  void draw() const;

private:
  struct Array {
    GLint components;
    std::size_t offset; ///< in bytes
  };
  void point(bool on) const;
  void pointGeneric(GLuint index, const Array &array, bool on) const;

  GLuint m_buffers[2] = {0, 0};
  Array m_position{}, m_normal{}, m_color{};
  std::vector<Array> m_sets;
  std::vector<unsigned> m_attribs;
  bool m_generic;
  GLsizei m_count;
};

} // namespace arbiter::tools
