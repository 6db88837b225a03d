#pragma once
#include <unordered_map>

#include <GL/gl.h>

#include "state/era/client_arrays.h"
#include "state/era/vertex_array_range.h"

namespace arbiter::state {

struct CoreContext;

/// The objects of APPLE_vertex_array_object in one context. Unlike the ARB's, they may hold arrays
/// in the application's memory, and names need not come from GenVertexArrays. So a bound object
/// lives in the host's default object, and the others are kept here. The command that first binds a
/// name decides whether it is Apple's or the host's. Both kinds share one name space, and either
/// command binds either kind.
class VertexArrayObjects {
public:
  /// True if Apple's objects exist. Until then all commands are the host's alone.
  [[nodiscard]] bool any() const { return !m_objects.empty(); }
  /// Returns Apple's object that is in the host's default object, or 0.
  [[nodiscard]] GLuint resident() const { return m_resident; }
  /// True if Apple has an object of that name.
  [[nodiscard]] bool has(GLuint name) const { return name != 0 && m_objects.count(name) != 0; }

  /// \param range the vertex array range, which is part of an object
  void bindApple(CoreContext &context, VertexArrayRange &range, GLuint name);
  /// Executes the ARB's command, for Apple's names too.
  void bind(CoreContext &context, VertexArrayRange &range, GLuint name);
  /// Deletes objects. A bound one is replaced by the default object.
  void remove(CoreContext &context, VertexArrayRange &range, GLsizei n, const GLuint *names);
  /// Replaces generated names that Apple's objects have: the host does not know those objects, so
  /// it may generate their names.
  void renameTaken(const CoreContext &context, GLsizei n, GLuint *names) const;

  /// Prepares the host's default object for a pop of the client attribute stack, which restores
  /// what it held when `pushed` was in it.
  void prepareRestore(CoreContext &context, const VertexArrayRange &range, GLuint pushed);
  /// Notes that the pop has put `pushed` into the default object.
  void restored(const CoreContext &context, GLuint pushed);

private:
  struct Object {
    ClientArrays arrays;
    VertexArrayRange range;
  };
  /// Saves the object in the host's default object, which must be bound.
  void keepResident(const CoreContext &context, const VertexArrayRange &range);
  void switchTo(CoreContext &context, VertexArrayRange &range, GLuint name);
  Object &objectOf(const CoreContext &context, GLuint name);

  std::unordered_map<GLuint, Object> m_objects; ///< the entry of the resident object is stale
  GLuint m_resident = 0;
};

} // namespace arbiter::state
