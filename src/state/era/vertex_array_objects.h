#pragma once
#include <unordered_map>

#include <GL/gl.h>

#include "state/era/client_arrays.h"
#include "state/era/vertex_array_range.h"

namespace arbiter::state {

class Context;

/// The vertex array objects of APPLE_vertex_array_object in one context. They differ from the
/// ARB's: arrays in the application's memory are allowed in them, and a name need not come from
/// GenVertexArrays. So each stands in the host's default object while it is bound, and is kept here
/// otherwise. An object is the ARB's, and the host's, or Apple's by the command that bound it
/// first; both kinds share one name space, and either command binds either kind.
class VertexArrayObjects {
public:
  /// Apple's objects exist: until then all commands are the host's alone.
  [[nodiscard]] bool any() const { return !m_objects.empty(); }
  /// The object of Apple's, or the default one (0), that is in the host's default object.
  [[nodiscard]] GLuint resident() const { return m_resident; }
  /// Whether there is an object of Apple's of that name.
  [[nodiscard]] bool has(GLuint name) const { return name != 0 && m_objects.count(name) != 0; }

  /// \param range the vertex array range, which an object has too
  void bindApple(Context &context, VertexArrayRange &range, GLuint name);
  /// The ARB's command; of names of Apple's too.
  void bind(Context &context, VertexArrayRange &range, GLuint name);
  /// What is bound gives way to the default object.
  void remove(Context &context, VertexArrayRange &range, GLsizei n, const GLuint *names);
  /// Of names that the host has generated, those of Apple's objects, which it does not know, are
  /// replaced by others.
  void renameTaken(const Context &context, GLsizei n, GLuint *names) const;

  /// Before the client attribute stack of the host gives its default object what it held when
  /// `pushed` was in it.
  void prepareRestore(Context &context, const VertexArrayRange &range, GLuint pushed);
  /// After it.
  void restored(const Context &context, GLuint pushed);

private:
  struct Object {
    ClientArrays arrays;
    VertexArrayRange range;
  };
  /// The object in the host's default one, which is current, is kept.
  void keepResident(const Context &context, const VertexArrayRange &range);
  void switchTo(Context &context, VertexArrayRange &range, GLuint name);
  Object &objectOf(const Context &context, GLuint name);

  std::unordered_map<GLuint, Object> m_objects; ///< the resident one's is as it was before
  GLuint m_resident = 0;
};

} // namespace arbiter::state
