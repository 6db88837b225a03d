// Enable, Disable and IsEnabled, for program targets and for capabilities that concern both the
// host and the layer.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/capability.h"
#include "state/core/errors.h"
#include "state/era/era_state.h"
#include "state/host_draw/clip_planes.h"
#include "state/host_draw/fixed_function.h"
#include "state/host_draw/sprite_commands.h"
#include "state/imaging/imaging_state.h"
#include "state/lists/issue_combiners.h"
#include "state/lists/list_compiler.h"
#include "state/pixel_commands/imaging_commands.h"
#include "state/programs/combiners/combiner_state.h"
#include "state/programs/nv/nv_state.h"
#include "state/programs/program_bind.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Records the command in a list. It is a separate function because a Command takes much stack.
[[gnu::noinline]] void record(Context &context, const ProgramTarget &row, bool enabled) {
  const auto kind = enabled ? Command::Kind::Enable : Command::Kind::Disable;
  listCompiler(context).record(context, {.kind = kind, .target = row.info().name});
}

/// Executes Enable and Disable of a program target.
void enable(Context &context, ProgramTarget &row, bool enabled) {
  if (context.insideBeginEnd) [[unlikely]] { // tested here to save a call
    (void)outsideBeginEnd(context, enabled ? "Enable between Begin and End"
                                           : "Disable between Begin and End");
    return;
  }
  if (!context.group->programApiUsed.load(std::memory_order_relaxed)) [[unlikely]]
    noteProgramApiUse(context);
  if (context.listMode)
    record(context, row, enabled);
  else
    setEnabled(context, row, enabled);
}

/// Executes Enable and Disable of an evaluator map of NV_vertex_program.
void setMap(Context &context, GLenum cap, bool enabled) {
  if (!outsideBeginEnd(context, "Enable or Disable between Begin and End"))
    return;
  context.mapsNamed = true;
  if (context.listMode)
    return listCompiler(context).record(
        context, {.kind = enabled ? Command::Kind::Enable : Command::Kind::Disable, .target = cap});
  enableMap(context, cap, enabled);
}

void setPerStageConstants(Context &context, bool enabled) {
  if (!outsideBeginEnd(context, "Enable or Disable between Begin and End"))
    return;
  CombinerCommand command{.kind = CombinerCommand::Kind::PerStageConstants};
  if (enabled)
    command.flags = CombinerCommand::kOn;
  issueCombinerCommand(context, command);
}

void setImaging(Context &context, GLenum cap, bool enabled) {
  if (!outsideBeginEnd(context, "Enable or Disable between Begin and End"))
    return;
  // Applications often disable all of it before they draw pixels, though they never enabled any.
  // Outside lists a command that changes nothing is therefore skipped.
  const bool isEnabled = (context.imaging->settings.enabled & imagingBitOf(cap)) != 0;
  if (enabled != isEnabled || context.listMode != 0)
    issueImaging(context, {.kind = ImagingCommand::Kind::Enable, .flag = enabled, .pname = cap});
}

bool hasPerStageConstants(const Context &context) {
  return context.combiners && context.combiners->hasPerStageConstants();
}

/// Notes that the host has executed an Enable or Disable.
void noteCapability(Context &context, Capability capability, bool enabled) {
  if (capability == Capability::FixedFunction)
    noteFixedFunctionCommand(context);
  else if (capability == Capability::ClipPlane)
    noteClipPlane(context, enabled);
  else if (capability == Capability::PointSprite)
    noteSpriteCommand(context);
  else if (capability == Capability::ProgramTarget)
    // The driver has the extension and not the layer. The mirror asks for the capability again
    // together with the queries (mirror_obstacles.cpp).
    context.dirty |= dirty::kQueries;
}

/// Executes Enable and Disable of a capability that is not the host's alone.
void setCapability(Context &context, GLenum cap, Capability capability, bool enabled) {
  if (ProgramTarget *const row = enableRowOf(context, cap))
    return enable(context, *row, enabled);
  if (capability == Capability::EvaluatorMap && context.nv)
    return setMap(context, cap, enabled);
  if (capability == Capability::PerStageConstants && hasPerStageConstants(context))
    return setPerStageConstants(context, enabled);
  if (capability == Capability::Imaging && context.imaging)
    return setImaging(context, cap, enabled);
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
  noteDirty(context, about);
  if (about.capability != Capability::Host) [[unlikely]]
    return setCapability(context, cap, about.capability, true);
  context.host->Enable(cap);
}

void Disable(Context &context, GLenum cap) {
  const CapabilityRow &about = rowOfCapability(cap);
  noteDirty(context, about);
  if (about.capability != Capability::Host) [[unlikely]]
    return setCapability(context, cap, about.capability, false);
  context.host->Disable(cap);
}

void Enablei(Context &context, GLenum target, GLuint index) {
  context.host->Enablei(target, index);
  // EXT_direct_state_access enables a unit's texture target so, which a shader variant depends on.
  noteCapability(context, rowOfCapability(target).capability, true);
}

void Disablei(Context &context, GLenum target, GLuint index) {
  context.host->Disablei(target, index);
  noteCapability(context, rowOfCapability(target).capability, false);
}

GLboolean IsEnabled(Context &context, GLenum cap) {
  const GLuint array = cap - GL_VERTEX_ATTRIB_ARRAY0_NV;
  if (context.nv && array < NvState::kAttributes) {
    GLint enabled = 0;
    if (outsideBeginEnd(context, "IsEnabled between Begin and End"))
      context.host->GetVertexAttribiv(array, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
    return enabled != 0 ? GL_TRUE : GL_FALSE;
  }
  if (context.nv && isEvaluatorMap(cap))
    return outsideBeginEnd(context, "IsEnabled between Begin and End") &&
                   (context.nv->enabledMaps >> evaluatorMapOf(cap) & 1u) != 0
               ? GL_TRUE
               : GL_FALSE;
  if (isVertexArrayRange(cap)) {
    GLint value = 0;
    if (eraValue(context, GL_VERTEX_ARRAY_RANGE_NV, value))
      return outsideBeginEnd(context, "IsEnabled between Begin and End") && value != 0 ? GL_TRUE
                                                                                       : GL_FALSE;
  }
  if (cap == GL_PER_STAGE_CONSTANTS_NV && hasPerStageConstants(context))
    return outsideBeginEnd(context, "IsEnabled between Begin and End") &&
                   context.combiners->state().perStageConstants
               ? GL_TRUE
               : GL_FALSE;
  if (const unsigned bit = context.imaging ? imagingBitOf(cap) : 0)
    return outsideBeginEnd(context, "IsEnabled between Begin and End") &&
                   (context.imaging->settings.enabled & bit) != 0
               ? GL_TRUE
               : GL_FALSE;
  const ProgramTarget *const row = enableRowOf(context, cap);
  if (!row)
    return context.host->IsEnabled(cap);
  if (!outsideBeginEnd(context, "IsEnabled between Begin and End"))
    return GL_FALSE;
  return row->enabled ? GL_TRUE : GL_FALSE;
}

} // namespace handlers
} // namespace arbiter::state
