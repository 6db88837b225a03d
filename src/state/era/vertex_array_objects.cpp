#include "state/era/vertex_array_objects.h"

#include "host/host_table.h"
#include "state/core/core_context.h"
#include "state/mirror/dirty_bits.h"

namespace arbiter::state {

VertexArrayObjects::Object &VertexArrayObjects::objectOf(const CoreContext &context, GLuint name) {
  return m_objects.try_emplace(name, Object{ClientArrays(context), {}}).first->second;
}

void VertexArrayObjects::keepResident(const CoreContext &context, const VertexArrayRange &range) {
  objectOf(context, m_resident) = {readArrays(context), range};
}

void VertexArrayObjects::switchTo(CoreContext &context, VertexArrayRange &range, GLuint name) {
  context.host->BindVertexArray(0);
  context.dirty |= dirty::kArrays;
  if (name == m_resident)
    return;
  const Object wanted = objectOf(context, name);
  keepResident(context, range);
  writeArrays(context, objectOf(context, m_resident).arrays, wanted.arrays);
  const bool spoken = range.spoken;
  range = wanted.range;
  range.spoken = spoken;
  m_resident = name;
}

void VertexArrayObjects::bindApple(CoreContext &context, VertexArrayRange &range, GLuint name) {
  if (context.host->IsVertexArray(name) == GL_TRUE)
    return context.host->BindVertexArray(name);
  if (name != 0 || any())
    switchTo(context, range, name);
  else
    context.host->BindVertexArray(0);
}

void VertexArrayObjects::bind(CoreContext &context, VertexArrayRange &range, GLuint name) {
  if (any() && (name == 0 || has(name)))
    switchTo(context, range, name);
  else
    context.host->BindVertexArray(name);
}

void VertexArrayObjects::remove(CoreContext &context, VertexArrayRange &range, GLsizei n,
                                const GLuint *names) {
  for (GLsizei i = 0; i < n; ++i) {
    if (!has(names[i]))
      continue;
    if (names[i] == m_resident) {
      GLint bound = 0; // an object of the ARB's may be bound
      context.host->GetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
      switchTo(context, range, 0);
      if (bound != 0)
        context.host->BindVertexArray(GLuint(bound));
    }
    m_objects.erase(names[i]);
  }
}

void VertexArrayObjects::renameTaken(const CoreContext &context, GLsizei n, GLuint *names) const {
  for (GLsizei i = 0; i < n; ++i)
    while (has(names[i])) // the host does not return the same name twice
      context.host->GenVertexArrays(1, &names[i]);
}

void VertexArrayObjects::prepareRestore(CoreContext &context, const VertexArrayRange &range,
                                        GLuint pushed) {
  if (pushed == m_resident)
    return;
  context.host->BindVertexArray(0);
  keepResident(context, range);
}

void VertexArrayObjects::restored(const CoreContext &context, GLuint pushed) {
  if (pushed != 0)
    (void)objectOf(context, pushed); // binding makes an object again that has been deleted
  m_resident = pushed;
}

} // namespace arbiter::state
