// Vertex attribute arrays of NV_vertex_program (2.14.3) and attribute queries (6.1.13). The arrays
// are the host's generic ones, as in NVIDIA's driver, so vertex array objects and the client
// attribute stack hold them. A draw chooses which of them a program reads (native_inputs.h).
#include <algorithm>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/era/era_state.h"
#include "state/host_draw/evaluators/nv_attributes.h"
#include "state/host_draw/native_inputs.h"
#include "state/mirror/attribute_aliases.h"
#include "state/mirror/dirty_bits.h"
#include "state/programs/nv/nv_state.h"

namespace arbiter::state {

namespace {

void setArrayEnabled(Context &context, GLuint index, bool enabled) {
  const auto get = [&] {
    GLint value = 0;
    context.host->GetVertexAttribiv(index, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &value);
    return value != 0;
  };
  const bool ofAll = enabled && (context.aliases->ofProgramsAlone >> index & 1u) == 0 && get();
  noteGenericArray(context, index, enabled);
  if (enabled && !ofAll)
    context.aliases->ofProgramsAlone |= 1u << index;
  context.dirty |= dirty::kArrays;
  (enabled ? context.host->EnableVertexAttribArray : context.host->DisableVertexAttribArray)(index);
}

GLenum pointerError(GLuint index, GLint size, GLenum type, GLsizei stride) {
  if (index >= NvState::kAttributes || size < 1 || size > 4 || stride < 0)
    return GL_INVALID_VALUE;
  if (type == GL_UNSIGNED_BYTE)
    return size == 4 ? GL_NO_ERROR : GL_INVALID_OPERATION;
  return type == GL_SHORT || type == GL_FLOAT || type == GL_DOUBLE ? GL_NO_ERROR : GL_INVALID_ENUM;
}

template <typename T> void getAttribute(Context &context, GLuint index, GLenum pname, T *params) {
  if (!outsideBeginEnd(context, "GetVertexAttrib between Begin and End"))
    return;
  const bool current = pname == GL_CURRENT_ATTRIB_NV;
  if (!current && pname != GL_ATTRIB_ARRAY_SIZE_NV && pname != GL_ATTRIB_ARRAY_STRIDE_NV &&
      pname != GL_ATTRIB_ARRAY_TYPE_NV)
    return raise(context, GL_INVALID_ENUM, "GetVertexAttrib: pname");
  if (index >= NvState::kAttributes || (current && index == 0))
    return raise(context, GL_INVALID_VALUE, "GetVertexAttrib: index");
  if (!params)
    return;
  if (current) {
    const Vec4 value = currentNvAttribute(context, index);
    std::transform(value.begin(), value.end(), params, rounded<T>);
    return;
  }
  GLint value = 0;
  context.host->GetVertexAttribiv(index, pname, &value); // the ARB's names are the same
  *params = T(value);
}

/// Enables or disables a vertex array range of the layer's. Returns false for other arrays.
bool setRangeEnabled(Context &context, GLenum array, bool enabled) {
  if (!isVertexArrayRange(array) || !context.era ||
      (!context.era->offered.nvRange && !context.era->offered.appleRange))
    return false;
  if (outsideBeginEnd(context, "a vertex array range's client state between Begin and End"))
    context.era->client.range.enabled = enabled;
  return true;
}

} // namespace

namespace handlers {

void EnableClientState(Context &context, GLenum array) {
  if (setRangeEnabled(context, array, true))
    return;
  const GLuint index = array - GL_VERTEX_ATTRIB_ARRAY0_NV;
  if (!context.nv || index >= NvState::kAttributes)
    return context.host->EnableClientState(array);
  if (outsideBeginEnd(context, "EnableClientState between Begin and End"))
    setArrayEnabled(context, index, true);
}

void DisableClientState(Context &context, GLenum array) {
  if (setRangeEnabled(context, array, false))
    return;
  const GLuint index = array - GL_VERTEX_ATTRIB_ARRAY0_NV;
  if (!context.nv || index >= NvState::kAttributes)
    return context.host->DisableClientState(array);
  if (outsideBeginEnd(context, "DisableClientState between Begin and End"))
    setArrayEnabled(context, index, false);
}

void VertexAttribPointerNV(Context &context, GLuint index, GLint fsize, GLenum type, GLsizei stride,
                           const void *pointer) {
  if (!outsideBeginEnd(context, "VertexAttribPointer between Begin and End"))
    return;
  if (const GLenum error = pointerError(index, fsize, type, stride); error != GL_NO_ERROR)
    return raise(context, error, "VertexAttribPointer: index, size, type or stride");
  context.dirty |= dirty::kArrays;
  const GLboolean normalized = type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE;
  context.host->VertexAttribPointer(index, fsize, type, normalized, stride, pointer);
}

void GetVertexAttribfvNV(Context &context, GLuint index, GLenum pname, GLfloat *params) {
  getAttribute<GLfloat>(context, index, pname, params);
}

void GetVertexAttribdvNV(Context &context, GLuint index, GLenum pname, GLdouble *params) {
  getAttribute<GLdouble>(context, index, pname, params);
}

void GetVertexAttribivNV(Context &context, GLuint index, GLenum pname, GLint *params) {
  getAttribute<GLint>(context, index, pname, params);
}

void GetVertexAttribPointervNV(Context &context, GLuint index, GLenum pname, void **pointer) {
  if (!outsideBeginEnd(context, "GetVertexAttribPointer between Begin and End"))
    return;
  if (pname != GL_ATTRIB_ARRAY_POINTER_NV)
    return raise(context, GL_INVALID_ENUM, "GetVertexAttribPointer: pname");
  if (index >= NvState::kAttributes)
    return raise(context, GL_INVALID_VALUE, "GetVertexAttribPointer: index");
  context.host->GetVertexAttribPointerv(index, pname, pointer);
}

} // namespace handlers
} // namespace arbiter::state
