#include "state/host_draw/clip_planes.h"

#include <algorithm>

#include "fp_compiler/ir/ir.h"
#include "host/host_table.h"
#include "state/host_draw/draw_context.h"
#include "state/objects/linked_program.h"
#include "state/programs/program_bind.h"
#include "state/programs/variants/clipped_variant.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

bool listsEnablePlanes(const DrawContext &context) {
  return context.group->listsEnableClipPlanes.load(std::memory_order_relaxed);
}

GLint planeCount(const DrawContext &context) {
  constexpr GLint kMaxPlanes = 8;
  return std::min(context.caps.maxClipPlanes, kMaxPlanes);
}

void askHost(DrawContext &context) {
  ClipPlanes &planes = context.clipPlanes;
  planes.mask = 0;
  for (GLint plane = 0; plane < planeCount(context); ++plane)
    if (context.host->IsEnabled(GLenum(GL_CLIP_PLANE0 + plane)))
      planes.mask |= std::uint8_t(1u << plane);
  planes.enabled = planes.mask != 0;
  planes.known = planes.maskKnown = true;
}

/// True if the effective GLSL writes distances to certain planes only.
bool drawsWithDistances(const DrawContext &context) {
  const LinkedProgram *const linked = context.effective.linkedProgram;
  return linked && linked->vertex.compiled && writesClipDistances(*linked->vertex.compiled);
}

bool vertexProgramsEnabled(const DrawContext &context) {
  return context.row(Target::Vertex).enabled || context.row(Target::VertexShader).enabled;
}

void invalidateClipPlanes(DrawContext &context) {
  context.clipPlanes.known = context.clipPlanes.maskKnown = false;
  if (vertexProgramsEnabled(context))
    invalidateProgram(context);
}

} // namespace

bool assemblyClipsOtherwise(const DrawContext &context, const CompiledProgram &vertex) {
  return writesClipDistances(vertex) ||
         (vertex.target == Target::VertexShader && !context.caps.planesClipPrograms);
}

bool clipPlanesMatter(DrawContext &context) {
  if (listsEnablePlanes(context))
    return true;
  ClipPlanes &planes = context.clipPlanes;
  if (!planes.used)
    return false;
  if (!planes.known)
    askHost(context);
  return planes.enabled;
}

std::uint8_t enabledClipPlanes(DrawContext &context) {
  if (!context.clipPlanes.maskKnown)
    askHost(context);
  return context.clipPlanes.mask;
}

void noteClipPlanesChange(DrawContext &context) {
  if (context.clipPlanes.used)
    return invalidateClipPlanes(context);
  noteClipPlanesAfterList(context); // lists may have enabled planes
}

void noteClipPlane(DrawContext &context, bool enabled) {
  if (context.insideBeginEnd)
    return; // it was an error
  if (!context.listMode) {
    ClipPlanes &planes = context.clipPlanes;
    if (enabled && planes.known && planes.enabled && !drawsWithDistances(context)) {
      planes.maskKnown = false;
      return; // another plane changes nothing but the mask
    }
    planes.used |= enabled;
    return noteClipPlanesChange(context);
  }
  const bool first = enabled && !listsEnablePlanes(context);
  if (first) {
    context.group->listsEnableClipPlanes.store(true, std::memory_order_relaxed);
    invalidateClipPlanes(context);
  }
  const bool drawsNow =
      context.listMode == GL_COMPILE_AND_EXECUTE && vertexProgramsEnabled(context);
  // The rest of the list is drawn with the variant that is effective now. A program that writes
  // distances needs the variant for the planes that are enabled when the list gets there.
  if ((first && drawsNow) || context.row(Target::Vertex).limits.nvOptions != 0)
    context.list->cut(context);
}

void copyClipPlanes(const DrawContext &from, DrawContext &to) {
  // The two contexts may belong to different share groups.
  to.clipPlanes.used |= from.clipPlanes.used || listsEnablePlanes(from);
  noteClipPlanesChange(to);
}

void noteClipPlanesOfLists(DrawContext &context) {
  if (!listsEnablePlanes(context) || !context.effective.linkedProgram)
    return;
  const CompiledProgram *const vertex = context.effective.linkedProgram->vertex.compiled;
  if (!vertex || !vertex->clipped || !vertex->program)
    return;
  // The host's own vertex programs are clipped by the host, as ARB vertex programs must be.
  if (!context.effective.linkedProgram->vertexAssembly || assemblyClipsOtherwise(context, *vertex))
    invalidateProgram(context);
}

void noteClipPlanesAfterList(DrawContext &context) {
  if (!listsEnablePlanes(context))
    return;
  context.clipPlanes.maskKnown = false;
  if (drawsWithDistances(context))
    invalidateProgram(context);
}

} // namespace arbiter::state
