#include "state/programs/parameters.h"

#include "state/core/errors.h"
#include "state/programs/program_context.h"

namespace arbiter::state {

/// Checks [index, index + count) against `size` without overflow.
bool isRange(ProgramContext &context, GLuint index, GLsizei count, std::size_t size,
             const char *command) {
  if (count >= 0 && index < size && std::size_t(count) <= size - index)
    return true;
  // An empty range at the end is no error, because nothing beyond the limit is touched.
  if (count == 0 && index <= size)
    return true;
  raise(context, GL_INVALID_VALUE, command);
  return false;
}

void setEnv(ProgramContext &context, ProgramTarget &row, GLuint index, GLsizei count,
            const Vec4 *values) {
  if (!isRange(context, index, count, row.env.size(), "ProgramEnvParameter: index"))
    return;
  for (GLsizei i = 0; i < count; ++i)
    if (!row.follows(index + GLuint(i))) // commands do not set parameters that track a matrix
      row.env[index + GLuint(i)] = values[i];
  ++row.envVersion;
  context.attention |= row.parameterBits;
}

void setLocal(ProgramContext &context, ProgramObject &object, GLuint index, GLsizei count,
              const Vec4 *values) {
  const std::size_t size = context.row(object.target).limits.localParameters;
  if (!isRange(context, index, count, size, "ProgramLocalParameter: index"))
    return;
  for (GLsizei i = 0; i < count; ++i)
    object.locals[index + GLuint(i)].store(values[i]);
  noteLocalsChanged(context, object);
}

void noteLocalsChanged(ProgramContext &context, ProgramObject &object) {
  ProgramTarget &row = context.row(object.target);
  if (row.bound.get() != &object)
    return object.changed();
  object.changed(row.seenVersion);
  context.attention |= row.parameterBits;
}

} // namespace arbiter::state
