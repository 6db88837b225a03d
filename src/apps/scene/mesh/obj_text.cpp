// Reads OBJ lines by a library that calls back. The library trusts the file's indices; this code
// does not.
#include <cmath>
#include <sstream>
#include <tiny_obj_loader.h>

#include "apps/scene/mesh/obj.h"

namespace arbiter::scene {

namespace {

constexpr int kMaxCorners = 256; ///< of a face: triangulation takes quadratic time

class Reader {
public:
  Result<ObjFaces, ObjError> run(const std::string &text) {
    tinyobj::callback_t calls;
    calls.vertex_cb = [](void *self, float x, float y, float z, float) {
      of(self).add(of(self).m_faces.positions, glm::vec3(x, y, z), "v");
    };
    calls.normal_cb = [](void *self, float x, float y, float z) {
      of(self).add(of(self).m_faces.normals, glm::vec3(x, y, z), "vn");
    };
    calls.texcoord_cb = [](void *self, float x, float y, float) {
      of(self).add(of(self).m_faces.sts, glm::vec2(x, y), "vt");
    };
    calls.index_cb = [](void *self, tinyobj::index_t *corners, int count) {
      of(self).addFace(corners, count);
    };
    std::istringstream stream(text);
    if (!tinyobj::LoadObjWithCallback(stream, calls, this, nullptr, nullptr, nullptr))
      complain("it is no OBJ text");
    if (m_faces.triangles.empty())
      complain("it has no face");
    if (!m_fault.empty())
      return ObjError{m_fault};
    return std::move(m_faces);
  }

private:
  static Reader &of(void *self) { return *static_cast<Reader *>(self); }

  /// Records a fault. The first one stays, as later ones may follow from it.
  void complain(const std::string &fault) {
    if (m_fault.empty())
      m_fault = fault;
  }

  template <typename Vector>
  void add(std::vector<Vector> &list, const Vector &value, const char *word) {
    const auto name = [&] { return std::string(word) + " " + std::to_string(list.size() + 1); };
    for (int i = 0; i < Vector::length(); ++i)
      if (!std::isfinite(value[i]))
        complain(name() + " is not finite");
    if (double(list.size()) >= kMaxVertices)
      complain(name() + " is one more than there may be");
    else
      list.push_back(value);
  }

  /// Converts an OBJ index: positive from 1, or negative from the end; 0: none.
  int numberOf(int index, std::size_t count, const char *what) {
    const auto size = int(count);
    if (index == 0)
      return -1;
    if (index <= size && index >= -size)
      return index > 0 ? index - 1 : size + index;
    complain("face " + std::to_string(m_count) + " names " + what + " " + std::to_string(index) +
             " of " + std::to_string(size));
    return -1;
  }

  void addFace(const tinyobj::index_t *corners, int count) {
    ++m_count;
    if (!m_fault.empty())
      return;
    if (count < 3 || count > kMaxCorners) {
      complain("face " + std::to_string(m_count) + " has " + std::to_string(count) +
               " corners, and may have 3 to 256");
      return;
    }
    std::vector<ObjFaces::Corner> all;
    all.reserve(std::size_t(count));
    for (int i = 0; i < count; ++i)
      all.push_back({numberOf(corners[i].vertex_index, m_faces.positions.size(), "vertex"),
                     numberOf(corners[i].texcoord_index, m_faces.sts.size(), "texture coordinate"),
                     numberOf(corners[i].normal_index, m_faces.normals.size(), "normal")});
    cut(all);
  }

  void cut(const std::vector<ObjFaces::Corner> &corners) {
    std::vector<glm::vec3> places;
    for (const ObjFaces::Corner &corner : corners) {
      if (corner.position < 0)
        complain("a corner of face " + std::to_string(m_count) + " names no vertex");
      if (!m_fault.empty())
        return;
      places.push_back(m_faces.positions[std::size_t(corner.position)]);
    }
    for (const auto &triangle : cutPolygon(places))
      m_faces.triangles.push_back(
          {corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]});
    if (double(m_faces.triangles.size()) * 3 > kMaxVertices)
      complain("it has more than 2097152 corners of triangles");
  }

  ObjFaces m_faces;
  std::string m_fault;
  std::size_t m_count = 0; ///< faces so far
};

} // namespace

Result<ObjFaces, ObjError> readObj(const std::string &text) { return Reader().run(text); }

} // namespace arbiter::scene
