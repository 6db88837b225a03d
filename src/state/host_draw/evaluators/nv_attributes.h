#pragma once
#include <cmath>
#include <type_traits>

#include <GL/gl.h>

#include "state/objects/target.h"

namespace arbiter::host {
struct HostTable;
}

/// Handles vertex attributes by number, where each number but 1, 6 and 7 is a conventional
/// attribute (NV_vertex_program 2.14.1.1, table X.2). The host's conventional normal, secondary
/// colour and fog coordinate have fewer than four components. For these, all four are also stored
/// in the generic attribute of the same number, where programs find the others
/// (state/programs/variants/attribute_forms.h).
namespace arbiter::state {

struct DrawContext;
struct ContextHot;

/// Converts a float as a Get of type \p T does: to the nearest integer (OpenGL 1.4, 6.1.2).
template <typename T> [[nodiscard]] T rounded(GLfloat value) {
  if constexpr (std::is_integral_v<T>)
    return T(std::lround(value));
  else
    return T(value);
}

/// Executes VertexAttribNV. Attribute 0 makes a vertex.
void setNvAttribute(DrawContext &context, GLuint index, const Vec4 &value);

/// Executes VertexAttrib, of the ARB and of OpenGL, for an aliased register while attributes alias.
/// The value also goes to the host's generic attribute, and to that alone while the application's
/// own GLSL shades vertices.
/// \param given number of components that the command has
void setAliasedAttribute(ContextHot &hot, GLuint index, const Vec4 &value, unsigned given);

/// Returns the current value of an attribute other than 0, with the components of table X.2. While
/// a primitive is recorded it is the recorder's, else the host's, which must have no open
/// primitive.
[[nodiscard]] Vec4 currentNvAttribute(const DrawContext &context, GLuint index);

/// Answers GetVertexAttrib of CURRENT_VERTEX_ATTRIB for an aliased register while attributes alias.
/// Returns false if the query is an error, which the host raises.
/// \param host the table for queries (raster_draw/immediate/held.h)
[[nodiscard]] bool getAliasedAttribute(const ContextHot &hot, const host::HostTable &host,
                                       GLuint index, GLfloat *values);
[[nodiscard]] bool getAliasedAttribute(const ContextHot &hot, const host::HostTable &host,
                                       GLuint index, GLdouble *values);
[[nodiscard]] bool getAliasedAttribute(const ContextHot &hot, const host::HostTable &host,
                                       GLuint index, GLint *values);

} // namespace arbiter::state
