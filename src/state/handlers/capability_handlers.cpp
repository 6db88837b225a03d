// Enable, Disable and IsEnabled: of program targets, and of what the host and the layer both look
// at.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/core/capability.h"
#include "state/core/context.h"
#include "state/core/errors.h"
#include "state/host_draw/clip_planes.h"
#include "state/host_draw/fixed_function.h"
#include "state/lists/list_compiler.h"
#include "state/programs/program_bind.h"

namespace arbiter::state {

namespace {

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
