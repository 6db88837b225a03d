#include "state/programs/program_bind.h"

#include "state/core/errors.h"
#include "state/programs/program_context.h"
#include "state/share/share_group.h"

namespace arbiter::state {

void noteProgramApiUse(ProgramContext &context) {
  if (!context.group->programApiUsed.load(std::memory_order_relaxed))
    context.group->programApiUsed.store(true, std::memory_order_relaxed);
}

std::shared_ptr<ProgramObject> namedProgram(ProgramContext &context, const ProgramTarget &row,
                                            GLuint name, Existence existence) {
  if (name == 0)
    return context.group->defaultProgram(row.target);
  std::shared_ptr<ProgramObject> object =
      context.group->findOrCreate(name, row.target, row.localsOfObject(), existence);
  if (object->target == row.target)
    return object;
  raise(context, GL_INVALID_OPERATION, "BindProgram: the object has another target");
  return nullptr;
}

void bindProgram(ProgramContext &context, ProgramTarget &row, GLuint name, Existence existence) {
  auto &recent = context.recentPrograms[name % context.recentPrograms.size()];
  if (!recent || recent->name != name || recent->target != row.target ||
      recent->deleted.load(std::memory_order_acquire) ||
      !recent->exists.load(std::memory_order_relaxed)) {
    std::shared_ptr<ProgramObject> object = namedProgram(context, row, name, existence);
    if (!object)
      return;
    recent = std::move(object);
  }
  // Binding the same object again has no effect, unless another context has changed it.
  if (row.bound == recent && row.seenVersion == recent->version.load(std::memory_order_acquire))
    return;
  row.bound = recent;
  invalidateProgram(context);
}

void setEnabled(ProgramContext &context, ProgramTarget &row, bool enabled) {
  if (row.enabled == enabled)
    return;
  row.enabled = enabled;
  if (followsFixedFunction(row.target))
    context.group->shadersFollowFixedFunction.store(true, std::memory_order_relaxed);
  invalidateProgram(context);
}

} // namespace arbiter::state
