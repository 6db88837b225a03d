// What else decides about a draw's path: the application's own GLSL, and attribute stacks.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/core/share_group.h"
#include "state/host_draw/clip_planes.h"
#include "state/host_draw/draw.h"
#include "state/host_draw/fixed_function.h"
#include "state/host_draw/host_assembly.h"
#include "state/lists/list_compiler.h"
#include "state/mirror/attribute_groups.h"
#include "state/programs/program_api.h"

namespace arbiter::state {

void useProgram(Context &context, GLuint name) {
  // The application's program must be the host's current one, for a call that fails to leave it.
  if (context.hostProgramIsOurs)
    releaseHostState(context);
  // A name that happens to be one of ours is one that the application never made.
  context.host->UseProgram(handlers::guardName(context, name));
  context.applicationProgramKnown = false;
  invalidateProgram(context);
}

namespace {

/// The host's own enable of the target is neither the application's to save nor to restore.
void releaseHostAssembly(Context &context) {
  if (!context.hostAssembly->active())
    return;
  releaseHostState(context);
  invalidateProgram(context);
}

} // namespace

void pushEnables(Context &context, GLbitfield mask) {
  AttribStack::Entry entry{.hasEnables = (mask & GL_ENABLE_BIT) != 0,
                           .dirty = software::dirtyGroupsOfAttributes(mask)};
  for (const ProgramTarget &row : context.targets)
    entry.enabledTargets |= std::uint8_t(std::uint8_t(row.enabled) << unsigned(row.target));
  (void)context.attribStack.push(entry);
}

namespace {

void popEnables(Context &context) {
  AttribStack::Entry entry;
  const bool popped = context.attribStack.pop(entry);
  context.dirty |= entry.dirty;
  if (!popped || !entry.hasEnables)
    return;
  for (ProgramTarget &row : context.targets)
    setEnabled(context, row, (entry.enabledTargets >> unsigned(row.target) & 1u) != 0);
}

} // namespace

void pushAttrib(Context &context, GLbitfield mask) {
  releaseHostAssembly(context);
  if ((mask & GL_TEXTURE_BIT) != 0)
    releaseSamplers(context);
  context.host->PushAttrib(mask); // raises STACK_OVERFLOW where ours would overflow too
  pushEnables(context, mask);
}

void popAttrib(Context &context) {
  releaseHostAssembly(context);
  context.host->PopAttrib();
  context.hostAssembly->disableAgain(context);
  popEnables(context);
  noteFixedFunctionChange(context);
  noteClipPlanesChange(context);
}

namespace handlers {

void UseProgram(Context &context, GLuint program) {
  if (context.insideBeginEnd)
    return context.host->UseProgram(program); // the host raises the error
  if (context.listMode) {
    if (context.group->programApiUsed.load(std::memory_order_relaxed))
      return context.list->record(context, {.kind = Command::Kind::UseProgram, .name = program});
    context.group->hostListsChangeProgram.store(true, std::memory_order_relaxed);
    return context.host->UseProgram(program);
  }
  useProgram(context, program);
}

void PushAttrib(Context &context, GLbitfield mask) {
  if (context.insideBeginEnd)
    return context.host->PushAttrib(mask);
  if (!context.listMode)
    return pushAttrib(context, mask);
  context.list->notePush(mask);
  if (context.listMode == GL_COMPILE_AND_EXECUTE)
    pushEnables(context, mask);
  context.host->PushAttrib(mask);
}

void PopAttrib(Context &context) {
  if (context.insideBeginEnd)
    return context.host->PopAttrib();
  if (!context.listMode)
    return popAttrib(context);
  if (context.list->notePop())
    return context.list->record(context, {.kind = Command::Kind::PopAttrib});
  context.host->PopAttrib();
  if (context.listMode == GL_COMPILE_AND_EXECUTE)
    popEnables(context);
  noteFixedFunctionCommand(context);
}

} // namespace handlers
} // namespace arbiter::state
