#include "state/programs/parameters.h"

#include <algorithm>

#include "state/core/context.h"
#include "state/core/errors.h"

namespace arbiter::state {

/// Checks [index, index + count) against `size` without overflow.
bool isRange(Context &context, GLuint index, GLsizei count, std::size_t size, const char *command) {
  if (count >= 0 && index < size && std::size_t(count) <= size - index)
    return true;
  // An empty range at the end is no error: nothing beyond the limit is touched.
  if (count == 0 && index <= size)
    return true;
  raise(context, GL_INVALID_VALUE, command);
  return false;
}

void setEnv(Context &context, ProgramTarget &row, GLuint index, GLsizei count, const Vec4 *values) {
  if (!isRange(context, index, count, row.env.size(), "ProgramEnvParameter: index"))
    return;
  std::copy_n(values, count, row.env.begin() + std::ptrdiff_t(index));
  ++row.envVersion;
  context.attention |= row.parameterBits;
}

void setLocal(Context &context, ProgramObject &object, GLuint index, GLsizei count,
              const Vec4 *values) {
  if (!isRange(context, index, count, object.locals.size(), "ProgramLocalParameter: index"))
    return;
  for (GLsizei i = 0; i < count; ++i)
    object.locals[index + GLuint(i)].store(values[i]);
  ProgramTarget &row = context.row(object.target);
  if (row.bound.get() != &object)
    return object.changed();
  object.changed(row.seenVersion);
  context.attention |= row.parameterBits;
}

} // namespace arbiter::state
