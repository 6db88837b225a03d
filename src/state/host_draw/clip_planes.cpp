#include "state/host_draw/clip_planes.h"

#include "host/host_table.h"
#include "state/core/context.h"
#include "state/host_draw/linked_program.h"
#include "state/host_draw/variants/clipped_variant.h"
#include "state/lists/list_compiler.h"
#include "state/programs/program_bind.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

bool listsEnablePlanes(const Context &context) {
  return context.group->listsEnableClipPlanes.load(std::memory_order_relaxed);
}

bool anyEnabled(Context &context) {
  for (GLint plane = 0; plane < context.caps.maxClipPlanes; ++plane)
    if (context.host->IsEnabled(GLenum(GL_CLIP_PLANE0 + plane)))
      return true;
  return false;
}

void invalidateClipPlanes(Context &context) {
  context.clipPlanes.known = false;
  if (context.row(Target::Vertex).enabled)
    invalidateProgram(context);
}

} // namespace

bool clipPlanesMatter(Context &context) {
  if (listsEnablePlanes(context))
    return true;
  ClipPlanes &planes = context.clipPlanes;
  if (!planes.used)
    return false;
  if (!planes.known) {
    planes.enabled = anyEnabled(context);
    planes.known = true;
  }
  return planes.enabled;
}

void noteClipPlanesChange(Context &context) {
  if (context.clipPlanes.used)
    invalidateClipPlanes(context);
}

void noteClipPlane(Context &context, bool enabled) {
  if (context.insideBeginEnd)
    return; // it was an error
  if (!context.listMode) {
    ClipPlanes &planes = context.clipPlanes;
    if (enabled && planes.known && planes.enabled)
      return; // one more
    planes.used |= enabled;
    return noteClipPlanesChange(context);
  }
  if (!enabled || listsEnablePlanes(context))
    return;
  context.group->listsEnableClipPlanes.store(true, std::memory_order_relaxed);
  invalidateClipPlanes(context);
  if (context.listMode == GL_COMPILE_AND_EXECUTE && context.row(Target::Vertex).enabled)
    context.list->cut(context); // what follows is drawn now, with the form that is effective now
}

void copyClipPlanes(const Context &from, Context &to) {
  // Neither of the groups need be the other's.
  to.clipPlanes.used |= from.clipPlanes.used || listsEnablePlanes(from);
  noteClipPlanesChange(to);
}

void noteClipPlanesOfLists(Context &context) {
  // The host clips what its own vertex programs give.
  if (listsEnablePlanes(context) && context.linkedProgram &&
      !context.linkedProgram->vertexAssembly && context.linkedProgram->vertex.compiled &&
      context.linkedProgram->vertex.compiled->clipped)
    invalidateProgram(context);
}

} // namespace arbiter::state
