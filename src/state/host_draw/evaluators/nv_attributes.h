#pragma once
#include <GL/gl.h>

#include "state/core/target.h"

namespace arbiter::host {
struct HostTable;
}

/// Vertex attributes of NV_vertex_program by their numbers: each but 1, 6 and 7 is a conventional
/// one (2.14.1.1, table X.2). Of the normal, the secondary colour and the fog coordinate the host's
/// conventional attribute has fewer components: all four are given to its generic one of the same
/// number as well, where programs find the others (state/host_draw/variants/attribute_forms.h).
namespace arbiter::state {

class Context;

/// VertexAttribNV. Attribute 0 makes a vertex.
void setNvAttribute(Context &context, GLuint index, const Vec4 &value);

/// The current value of an attribute but 0, with the components of table X.2: while a primitive is
/// recorded that is the recorder's, else the host's, which must be outside of Begin and End.
[[nodiscard]] Vec4 currentNvAttribute(const Context &context, GLuint index);

} // namespace arbiter::state
