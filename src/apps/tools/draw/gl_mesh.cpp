#include "apps/tools/draw/gl_mesh.h"

#include <algorithm>

#include "apps/tools/draw/gl_queries.h"

namespace arbiter::tools {

namespace {

// NOLINTNEXTLINE(performance-no-int-to-ptr): with a buffer bound, GL takes an offset here.
const void *pointer(std::size_t offset) { return reinterpret_cast<const void *>(offset); }

void setClient(GLenum array, bool on) {
  if (on)
    glEnableClientState(array);
  else
    glDisableClientState(array);
}

} // namespace

GlMesh::GlMesh(const scene::Mesh &mesh, const std::vector<scene::CoordinateSpec> &coordinates,
               bool vertexProgram, const std::vector<unsigned> &attribs)
    : m_attribs(attribs), m_generic(vertexProgram), m_count(GLsizei(mesh.indices.size())) {
  std::vector<float> data;
  const auto add = [&](GLint components, auto value) {
    const Array array{components, data.size() * sizeof(float)};
    for (const scene::MeshVertex &vertex : mesh.vertices) {
      const glm::vec4 all = value(vertex);
      for (int i = 0; i < components; ++i)
        data.push_back(all[i]);
    }
    return array;
  };
  m_position = add(3, [](const auto &vertex) { return glm::vec4(vertex.position, 1); });
  m_normal = add(3, [](const auto &vertex) { return glm::vec4(vertex.normal, 1); });
  m_color = add(4, [](const auto &vertex) { return glm::vec4(vertex.st, 0, 1); });
  m_sets.assign(std::size_t(std::clamp(query(GL_MAX_TEXTURE_COORDS_ARB), 1, 8)), m_color);
  for (const scene::CoordinateSpec &spec : coordinates)
    if (spec.set < m_sets.size())
      m_sets[spec.set] =
          add(4, [&](const auto &vertex) { return scene::coordinateOf(vertex, spec); });
  glGenBuffers(2, m_buffers);
  glBindBuffer(GL_ARRAY_BUFFER, m_buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(data.size() * sizeof(float)), data.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * sizeof(std::uint32_t)),
               mesh.indices.data(), GL_STATIC_DRAW);
}

GlMesh::~GlMesh() { glDeleteBuffers(2, m_buffers); }

void GlMesh::pointGeneric(GLuint index, const Array &array, bool on) const {
  if (std::find(m_attribs.begin(), m_attribs.end(), index) != m_attribs.end())
    return;
  if (!on) {
    glDisableVertexAttribArrayARB(index);
    return;
  }
  glVertexAttribPointerARB(index, array.components, GL_FLOAT, GL_FALSE, 0, pointer(array.offset));
  glEnableVertexAttribArrayARB(index);
}

void GlMesh::point(bool on) const {
  glVertexPointer(m_position.components, GL_FLOAT, 0, pointer(m_position.offset));
  glNormalPointer(GL_FLOAT, 0, pointer(m_normal.offset));
  glColorPointer(m_color.components, GL_FLOAT, 0, pointer(m_color.offset));
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY})
    setClient(array, on);
  for (std::size_t set = 0; set < m_sets.size(); ++set) {
    glClientActiveTexture(GL_TEXTURE0 + GLenum(set));
    glTexCoordPointer(m_sets[set].components, GL_FLOAT, 0, pointer(m_sets[set].offset));
    setClient(GL_TEXTURE_COORD_ARRAY, on);
  }
  if (!m_generic)
    return;
  constexpr GLuint kNormal = 2, kColor = 3, kFirstSet = 8;
  pointGeneric(kNormal, m_normal, on);
  pointGeneric(kColor, m_color, on);
  for (std::size_t set = 0; set < m_sets.size(); ++set)
    pointGeneric(kFirstSet + GLuint(set), m_sets[set], on);
}

void GlMesh::draw() const {
  glBindBuffer(GL_ARRAY_BUFFER, m_buffers[0]);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffers[1]);
  point(true);
  glDrawElements(GL_TRIANGLES, m_count, GL_UNSIGNED_INT, nullptr);
  point(false);
}

} // namespace arbiter::tools
