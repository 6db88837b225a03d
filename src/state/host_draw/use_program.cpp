// Handles other commands that decide about a draw's path: the application's own GLSL, and attribute
// stacks.
#include "state/host_draw/use_program.h"

#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/era/era_state.h"
#include "state/era/texture_range.h"
#include "state/host_draw/clip_planes.h"
#include "state/host_draw/current_values.h"
#include "state/host_draw/draw.h"
#include "state/host_draw/draw_context.h"
#include "state/host_draw/fixed_function.h"
#include "state/host_draw/linking/host_assembly.h"
#include "state/host_draw/stages/application_glsl.h"
#include "state/host_draw/texturing/sampler_override.h"
#include "state/imaging/imaging_state.h"
#include "state/mirror/attribute_aliases.h"
#include "state/mirror/attribute_groups.h"
#include "state/programs/combiners/combiner_state.h"
#include "state/programs/nv/nv_state.h"
#include "state/programs/program_bind.h"
#include "state/programs/texture_changes.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/programs/variants/point_sprites.h"
#include "state/share/share_group.h"

namespace arbiter::state {

void useProgram(DrawContext &context, GLuint name) {
  // If the call fails, the application's program must remain current, so it is restored first.
  if (context.hostProgramIsOurs)
    releaseHostState(context);
  // The application cannot have created an object with a name of the layer's.
  context.host->UseProgram(guardedName(context, name));
  context.application.programKnown = false;
  invalidateProgram(context);
  if (!context.aliases) [[likely]]
    return;
  GLint current = 0;
  context.host->GetIntegerv(GL_CURRENT_PROGRAM, &current);
  context.aliases->ofGlsl = current != 0 && stagesOf(context, GLuint(current)).vertex;
}

void pushEnables(DrawContext &context, GLbitfield mask) {
  AttribStack::Entry entry{.hasEnables = (mask & GL_ENABLE_BIT) != 0,
                           .dirty = dirtyGroupsOfAttributes(mask)};
  for (const ProgramTarget &row : context.targets)
    entry.enabledTargets |= std::uint8_t(std::uint8_t(row.enabled) << unsigned(row.target));
  if (context.nv) {
    entry.hasMaps = (mask & (GL_ENABLE_BIT | GL_EVAL_BIT)) != 0;
    entry.enabledMaps = context.nv->enabledMaps;
  }
  if (context.era && (mask & GL_HINT_BIT) != 0)
    entry.hints = context.era->hints;
  if (context.era && (mask & GL_POINT_BIT) != 0)
    entry.spriteMode = context.era->sprites.rMode;
  if ((mask & GL_TEXTURE_BIT) != 0)
    entry.textureRanges = saveTextureRanges(context);
  if (context.combiners) {
    entry.perStageConstants = context.combiners->state().perStageConstants;
    if ((mask & GL_TEXTURE_BIT) != 0)
      entry.combiners = context.combiners->settings();
  }
  entry.hasTextures = (mask & GL_TEXTURE_BIT) != 0;
  if (context.textureShaders && (mask & GL_TEXTURE_BIT) != 0)
    entry.textureShaders = context.textureShaders->settings();
  if (context.textureShaders && (mask & GL_PIXEL_MODE_BIT) != 0)
    entry.transfers = std::make_shared<const ComponentTransfers>(context.textureShaders->transfers);
  if (context.imaging) {
    entry.hasPixelMode = (mask & GL_PIXEL_MODE_BIT) != 0;
    entry.hasMatrixMode = (mask & GL_TRANSFORM_BIT) != 0;
    entry.colorMatrix = context.imagesPixels && context.imaging->colorMatrix.isCurrent(context);
    if (context.imagesPixels && (entry.hasPixelMode || entry.hasEnables))
      entry.imaging = std::make_shared<const imaging::Settings>(context.imaging->settings);
  }
  (void)context.attribStack.push(std::move(entry));
}

/// Restores register combiners. Their state and both enables belong to GL_TEXTURE_BIT, the enables
/// to GL_ENABLE_BIT too.
void popCombiners(DrawContext &context, const AttribStack::Entry &entry) {
  ProgramTarget &row = context.row(Target::Combiners);
  if (entry.combiners) {
    context.combiners->restore(context, entry.combiners);
    setEnabled(context, row, (entry.enabledTargets >> unsigned(row.target) & 1u) != 0);
  } else if (entry.hasEnables) {
    context.combiners->set(
        context, [](auto &state) -> auto & { return state.perStageConstants; },
        entry.perStageConstants);
  }
}

/// Restores texture shaders. If the context had none when it pushed, it restores the initial state.
void popTextureShaders(DrawContext &context, const AttribStack::Entry &entry) {
  ProgramTarget &row = context.row(Target::TextureShaders);
  if (entry.hasTextures && !entry.textureShaders)
    context.textureShaders->restore(context, std::make_shared<TextureShaderSettings>());
  if (entry.textureShaders) {
    context.textureShaders->restore(context, entry.textureShaders);
    setEnabled(context, row, (entry.enabledTargets >> unsigned(row.target) & 1u) != 0);
  }
  if (entry.transfers)
    context.textureShaders->transfers = *entry.transfers;
}

/// Restores ARB_imaging's state. An entry without it stands for the initial state.
void popImaging(DrawContext &context, const AttribStack::Entry &entry) {
  ImagingState &state = *context.imaging;
  const imaging::Settings before = entry.imaging ? *entry.imaging : imaging::Settings{};
  if (entry.hasPixelMode)
    state.settings = before;
  else if (entry.hasEnables)
    state.settings.enabled = before.enabled;
  if (entry.hasMatrixMode)
    state.colorMatrix.restore(context, entry.colorMatrix);
}

void popEnables(DrawContext &context) {
  AttribStack::Entry entry;
  const bool popped = context.attribStack.pop(entry);
  context.dirty |= entry.dirty;
  if (popped && entry.hasMaps && context.nv)
    context.nv->enabledMaps = entry.enabledMaps;
  if (popped && entry.hints && context.era)
    context.era->hints = *entry.hints;
  if (popped && entry.spriteMode && context.era && context.era->offered.pointSprite)
    setSpriteMode(context, *entry.spriteMode);
  if (popped && entry.textureRanges)
    restoreTextureRanges(context, *entry.textureRanges);
  if (popped && context.imagesPixels)
    popImaging(context, entry);
  if (popped && context.combiners)
    popCombiners(context, entry);
  if (popped && context.textureShaders)
    popTextureShaders(context, entry);
  if (!popped || !entry.hasEnables)
    return;
  for (ProgramTarget &row : context.targets)
    setEnabled(context, row, (entry.enabledTargets >> unsigned(row.target) & 1u) != 0);
}

void pushAttrib(DrawContext &context, GLbitfield mask) {
  if ((mask & GL_TEXTURE_BIT) != 0)
    releaseSamplers(context);
  releaseSprites(context);
  context.host->PushAttrib(mask); // also raises STACK_OVERFLOW if the layer's stack is full
  pushEnables(context, mask);
}

void popAttrib(DrawContext &context) {
  releaseSprites(context);
  if (context.softwareListens && (context.attribStack.restores() & dirty::kCurrent) != 0)
    settleCurrentValues(*context.host);
  context.host->PopAttrib();
  // The enables that the layer itself made on the host must be neither saved nor restored.
  context.hostSide.assembly->restoreEnables(context);
  popEnables(context);
  noteFixedFunctionChange(context);
  noteTextureChange(context);
  noteClipPlanesChange(context);
}

} // namespace arbiter::state
