// Commands that set vertex attributes of NV_vertex_program (2.14.1.1).
// state/host_draw/evaluators/nv_attributes.h explains these attributes.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/host_draw/evaluators/nv_attributes.h"
#include "state/programs/nv/nv_state.h"

namespace arbiter::state {

namespace {

void setAttribute(Context &context, GLuint index, const Vec4 &value) {
  if (index >= NvState::kAttributes)
    return raise(context, GL_INVALID_VALUE, "VertexAttrib: index");
  setNvAttribute(context, index, value);
  if (context.nv->evaluation) [[unlikely]]
    context.nv->evaluation->current[index] = value;
}

/// Converts a component: bytes map to [0,1] (table 2.6), other types keep their value.
GLfloat converted(GLubyte value) { return GLfloat(value) / 255.0f; }
template <typename T> GLfloat converted(T value) { return GLfloat(value); }

template <std::size_t kCount, typename T> void setFrom(Context &context, GLuint index, const T *v) {
  Vec4 value = {0.0f, 0.0f, 0.0f, 1.0f};
  for (std::size_t i = 0; i < kCount; ++i)
    value[i] = converted(v[i]);
  setAttribute(context, index, value);
}

/// Sets several attributes, the last one first, so that the position comes last (2.14.1.1).
template <std::size_t kCount, typename T>
void setSeveral(Context &context, GLuint index, GLsizei count, const T *v) {
  if (count < 0 || index > NvState::kAttributes || GLuint(count) > NvState::kAttributes - index)
    return raise(context, GL_INVALID_VALUE, "VertexAttribs: index or count");
  for (GLsizei i = count; i-- > 0;)
    setFrom<kCount>(context, index + GLuint(i), v + std::size_t(i) * kCount);
}

} // namespace

namespace handlers {

#define ATTRIBUTES(n, letter, T)                                                                   \
  void VertexAttrib##n##letter##vNV(Context &context, GLuint index, const T *v) {                  \
    setFrom<n>(context, index, v);                                                                 \
  }                                                                                                \
  void VertexAttribs##n##letter##vNV(Context &context, GLuint index, GLsizei count, const T *v) {  \
    setSeveral<n>(context, index, count, v);                                                       \
  }
#define ATTRIBUTES_OF_TYPE(letter, T)                                                              \
  ATTRIBUTES(1, letter, T)                                                                         \
  ATTRIBUTES(2, letter, T)                                                                         \
  ATTRIBUTES(3, letter, T)                                                                         \
  ATTRIBUTES(4, letter, T)                                                                         \
  void VertexAttrib1##letter##NV(Context &context, GLuint index, T x) {                            \
    setFrom<1>(context, index, &x);                                                                \
  }                                                                                                \
  void VertexAttrib2##letter##NV(Context &context, GLuint index, T x, T y) {                       \
    const T v[] = {x, y};                                                                          \
    setFrom<2>(context, index, v);                                                                 \
  }                                                                                                \
  void VertexAttrib3##letter##NV(Context &context, GLuint index, T x, T y, T z) {                  \
    const T v[] = {x, y, z};                                                                       \
    setFrom<3>(context, index, v);                                                                 \
  }                                                                                                \
  void VertexAttrib4##letter##NV(Context &context, GLuint index, T x, T y, T z, T w) {             \
    const T v[] = {x, y, z, w};                                                                    \
    setFrom<4>(context, index, v);                                                                 \
  }

ATTRIBUTES_OF_TYPE(s, GLshort)
ATTRIBUTES_OF_TYPE(f, GLfloat)
ATTRIBUTES_OF_TYPE(d, GLdouble)
ATTRIBUTES(4, ub, GLubyte)
#undef ATTRIBUTES_OF_TYPE
#undef ATTRIBUTES

void VertexAttrib4ubNV(Context &context, GLuint index, GLubyte x, GLubyte y, GLubyte z, GLubyte w) {
  const GLubyte v[] = {x, y, z, w};
  setFrom<4>(context, index, v);
}

} // namespace handlers
} // namespace arbiter::state
