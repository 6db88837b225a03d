#pragma once
#include <cmath>
#include <type_traits>

#include <GL/gl.h>

#include "state/objects/target.h"

namespace arbiter::host {
struct HostTable;
}

/// Vertex attributes by their numbers, where each but 1, 6 and 7 is a conventional one
/// (NV_vertex_program 2.14.1.1, table X.2). Of the normal, the secondary colour and the fog
/// coordinate the host's conventional attribute has fewer components: all four are given to its
/// generic one of the same number as well, where programs find the others
/// (state/programs/variants/attribute_forms.h).
namespace arbiter::state {

class Context;
struct ContextHot;

/// A float as a Get of type \p T answers it: integers are the nearest (OpenGL 1.4, 6.1.2).
template <typename T> [[nodiscard]] T rounded(GLfloat value) {
  if constexpr (std::is_integral_v<T>)
    return T(std::lround(value));
  else
    return T(value);
}

/// VertexAttribNV. Attribute 0 makes a vertex.
void setNvAttribute(Context &context, GLuint index, const Vec4 &value);

/// Does VertexAttrib, the ARB's and OpenGL's, of an aliased register where attributes alias. The
/// host's generic attribute is given the value too, and while the application's own GLSL shades
/// vertices it alone is.
/// \param given components that the command has
void setAliasedAttribute(ContextHot &hot, GLuint index, const Vec4 &value, unsigned given);

/// The current value of an attribute but 0, with the components of table X.2: while a primitive is
/// recorded that is the recorder's, else the host's, which must be outside of Begin and End.
[[nodiscard]] Vec4 currentNvAttribute(const Context &context, GLuint index);

/// Answers GetVertexAttrib of CURRENT_VERTEX_ATTRIB, of an aliased register where attributes alias.
/// False: the question is an error, the host's to raise.
/// \param host whom the application asks (raster_draw/immediate/held.h)
[[nodiscard]] bool getAliasedAttribute(const ContextHot &hot, const host::HostTable &host,
                                       GLuint index, GLfloat *values);
[[nodiscard]] bool getAliasedAttribute(const ContextHot &hot, const host::HostTable &host,
                                       GLuint index, GLdouble *values);
[[nodiscard]] bool getAliasedAttribute(const ContextHot &hot, const host::HostTable &host,
                                       GLuint index, GLint *values);

} // namespace arbiter::state
