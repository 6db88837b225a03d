#pragma once
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include <GL/gl.h>

#include "state/objects/name_ranges.h"
#include "state/objects/program_object.h"

namespace arbiter::state {

using ProgramObjects = std::unordered_map<GLuint, std::shared_ptr<ProgramObject>>;

/// Removes the object of that name and returns it, or null. The object lives on where it is bound.
inline std::shared_ptr<ProgramObject> takeOut(ProgramObjects &objects, GLuint name) {
  const auto it = objects.find(name);
  if (it == objects.end())
    return nullptr;
  std::shared_ptr<ProgramObject> object = std::move(it->second);
  objects.erase(it);
  object->deleted.store(true, std::memory_order_release);
  return object;
}

/// The shader objects of ATI_fragment_shader (3.8.11) or EXT_vertex_shader (2.14) in a share group,
/// which have a name space of their own. They are program objects of target AtiApi or VertexShader,
/// so that draws and queries handle one kind of object.
class ShaderTable {
public:
  explicit ShaderTable(Target target) : m_target(target) {}

  /// Executes GenFragmentShadersATI or GenVertexShadersEXT. Returns the first of `range`
  /// consecutive names, or 0 if there are none.
  [[nodiscard]] GLuint generate(GLuint range) {
    const std::lock_guard lock(m_mutex);
    return m_names.reserveRow(range);
  }

  /// Returns the object of that name, created at first use. Requires name != 0.
  [[nodiscard]] std::shared_ptr<ProgramObject> findOrCreate(GLuint name) {
    const std::lock_guard lock(m_mutex);
    if (const auto it = m_objects.find(name); it != m_objects.end())
      return it->second;
    auto object = std::make_shared<ProgramObject>(name, m_target);
    m_names.reserve(name);
    m_objects.emplace(name, object);
    return object;
  }

  /// Frees the name and returns its object, or null. The object lives on where it is bound.
  std::shared_ptr<ProgramObject> remove(GLuint name) {
    const std::lock_guard lock(m_mutex);
    m_names.release(name);
    return takeOut(m_objects, name);
  }

  /// Returns all objects that exist now.
  [[nodiscard]] std::vector<std::shared_ptr<ProgramObject>> objects() {
    const std::lock_guard lock(m_mutex);
    std::vector<std::shared_ptr<ProgramObject>> all;
    for (const auto &[name, object] : m_objects)
      all.push_back(object);
    return all;
  }

private:
  const Target m_target;
  std::mutex m_mutex;
  NameRanges m_names;
  ProgramObjects m_objects;
};

} // namespace arbiter::state
