// Names, binding, enabling: Gen, Delete, Is, Bind, Enable, Disable, IsEnabled (3.11.1, 6.1.12).
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/core/capability.h"
#include "state/core/errors.h"
#include "state/core/share_group.h"
#include "state/host_draw/clip_planes.h"
#include "state/host_draw/fixed_function.h"
#include "state/lists/list_compiler.h"
#include "state/programs/program_api.h"

namespace arbiter::state {

bool outsideBeginEnd(Context &context, const char *command) {
  if (!context.insideBeginEnd) [[likely]]
    return true;
  raise(context, GL_INVALID_OPERATION, command);
  return false;
}

void noteProgramApiUse(Context &context) {
  if (!context.group->programApiUsed.load(std::memory_order_relaxed))
    context.group->programApiUsed.store(true, std::memory_order_relaxed);
}

void invalidateProgram(Context &context) {
  // Sticky bits of the program that was effective go; selecting sets them anew.
  context.attention = attention::kProgram | (context.attention & attention::kList);
}

std::shared_ptr<ProgramObject> namedProgram(Context &context, const ProgramTarget &row,
                                            GLuint name) {
  if (name == 0)
    return context.group->defaultProgram(row.target);
  std::shared_ptr<ProgramObject> object =
      context.group->findOrCreate(name, row.target, row.limits.localParameters);
  if (object->target == row.target)
    return object;
  raise(context, GL_INVALID_OPERATION, "BindProgram: the object has another target");
  return nullptr;
}

void bindProgram(Context &context, ProgramTarget &row, GLuint name) {
  auto &recent = context.recentPrograms[name % context.recentPrograms.size()];
  if (!recent || recent->name != name || recent->target != row.target ||
      recent->deleted.load(std::memory_order_acquire)) {
    std::shared_ptr<ProgramObject> object = namedProgram(context, row, name);
    if (!object)
      return;
    recent = std::move(object);
  }
  // Binding the same object again matters only where another context changed it.
  if (row.bound == recent && row.seenVersion == recent->version.load(std::memory_order_acquire))
    return;
  row.bound = recent;
  invalidateProgram(context);
}

void setEnabled(Context &context, ProgramTarget &row, bool enabled) {
  if (row.enabled == enabled)
    return;
  row.enabled = enabled;
  if (row.info().language == fp::ir::Language::AtiFragment)
    context.group->atiShadersUsed.store(true, std::memory_order_relaxed);
  invalidateProgram(context);
}

namespace {

void deleteProgram(Context &context, GLuint name) {
  const std::shared_ptr<ProgramObject> object = context.group->remove(name);
  if (!object)
    return;
  ProgramTarget &row = context.row(object->target);
  if (row.bound == object) {
    row.bound = context.group->defaultProgram(row.target);
    invalidateProgram(context);
  }
  auto &recent = context.recentPrograms[name % context.recentPrograms.size()];
  if (recent == object)
    recent = nullptr;
  // Other contexts may have it bound; their linked programs go when they are swept.
  const auto compiled = context.group->compiledOf(*object);
  if (compiled)
    dropVariants(context, *compiled);
}

/// Enable and Disable of a program target.
void enable(Context &context, ProgramTarget &row, bool enabled) {
  if (!outsideBeginEnd(context,
                       enabled ? "Enable between Begin and End" : "Disable between Begin and End"))
    return;
  noteProgramApiUse(context);
  if (!context.listMode)
    return setEnabled(context, row, enabled);
  const auto kind = enabled ? Command::Kind::Enable : Command::Kind::Disable;
  context.list->record(context, {.kind = kind, .target = row.info().name});
}

/// After the host's Enable or Disable.
void noteCapability(Context &context, Capability capability, bool enabled) {
  if (capability == Capability::ChoosesForm)
    noteFixedFunctionCommand(context);
  else if (capability == Capability::ClipPlane)
    noteClipPlane(context, enabled);
}

/// Enable and Disable of a capability that is not the host's alone.
[[gnu::noinline]] void setCapability(Context &context, GLenum cap, Capability capability,
                                     bool enabled) {
  if (ProgramTarget *const row = enableRowOf(context, cap))
    return enable(context, *row, enabled);
  if (enabled)
    context.host->Enable(cap);
  else
    context.host->Disable(cap);
  noteCapability(context, capability, enabled);
}

} // namespace

namespace handlers {

void BindProgramARB(Context &context, GLenum target, GLuint program) {
  if (!outsideBeginEnd(context, "BindProgram between Begin and End"))
    return;
  ProgramTarget *const row = rowOf(context, target);
  if (!row)
    return context.host->BindProgramARB(target, program); // raises INVALID_ENUM, or knows it
  noteProgramApiUse(context);
  if (context.listMode)
    return context.list->record(
        context, {.kind = Command::Kind::BindProgram, .target = target, .name = program});
  bindProgram(context, *row, program);
}

void GenProgramsARB(Context &context, GLsizei n, GLuint *programs) {
  if (!outsideBeginEnd(context, "GenPrograms between Begin and End"))
    return;
  if (n < 0)
    return raise(context, GL_INVALID_VALUE, "GenPrograms: n is negative");
  if (!programs)
    return;
  noteProgramApiUse(context);
  for (GLsizei i = 0; i < n; ++i)
    programs[i] = context.group->takeName();
}

void DeleteProgramsARB(Context &context, GLsizei n, const GLuint *programs) {
  if (!outsideBeginEnd(context, "DeletePrograms between Begin and End"))
    return;
  if (n < 0)
    return raise(context, GL_INVALID_VALUE, "DeletePrograms: n is negative");
  if (!programs)
    return;
  for (GLsizei i = 0; i < n; ++i)
    if (programs[i] != 0)
      deleteProgram(context, programs[i]);
}

GLboolean IsProgramARB(Context &context, GLuint program) {
  if (!outsideBeginEnd(context, "IsProgram between Begin and End"))
    return GL_FALSE;
  // An object exists once its name was bound; a name that Gen returned is none yet.
  return program != 0 && context.group->contains(program) ? GL_TRUE : GL_FALSE;
}

void Enable(Context &context, GLenum cap) {
  const CapabilityRow &about = rowOfCapability(cap);
  context.dirty |= about.dirty;
  if (about.capability != Capability::Host) [[unlikely]]
    return setCapability(context, cap, about.capability, true);
  context.host->Enable(cap);
}

void Disable(Context &context, GLenum cap) {
  const CapabilityRow &about = rowOfCapability(cap);
  context.dirty |= about.dirty;
  if (about.capability != Capability::Host) [[unlikely]]
    return setCapability(context, cap, about.capability, false);
  context.host->Disable(cap);
}

void Enablei(Context &context, GLenum target, GLuint index) {
  context.host->Enablei(target, index);
  noteCapability(context, rowOfCapability(target).capability,
                 true); // EXT_direct_state_access: a unit's enable
}

void Disablei(Context &context, GLenum target, GLuint index) {
  context.host->Disablei(target, index);
  noteCapability(context, rowOfCapability(target).capability, false);
}

GLboolean IsEnabled(Context &context, GLenum cap) {
  const ProgramTarget *const row = enableRowOf(context, cap);
  if (!row)
    return context.host->IsEnabled(cap);
  if (!outsideBeginEnd(context, "IsEnabled between Begin and End"))
    return GL_FALSE;
  return row->enabled ? GL_TRUE : GL_FALSE;
}

} // namespace handlers
} // namespace arbiter::state
