#include "state/raster_draw/commands.h"

#include "host/host_table.h"
#include "state/core/memory.h"
#include "state/host_draw/current_values.h"
#include "state/host_draw/draw.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/decision.h"
#include "state/raster_draw/immediate/primitive.h"

namespace arbiter::state {

namespace {

/// Adds a rectangle's vertices in the order of section 2.10.
void addRectangle(ImmediateRecorder &to, GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2) {
  to.vertex(x1, y1, 0, 1);
  to.vertex(x2, y1, 0, 1);
  to.vertex(x2, y2, 0, 1);
  to.vertex(x1, y2, 0, 1);
}

/// Returns the primitive for glRect. Section 2.10 asks for a POLYGON, whose flat colour is its
/// first vertex's. Smooth rectangles use QUADS, as the host does, so that they are split alike.
GLenum rectangleMode(RasterContext &context) {
  Mirror &mirror = context.software->mirror;
  mirror.refresh(context.dirty);
  return mirror.raster.flatShade ? GL_POLYGON : GL_QUADS;
}

} // namespace

bool tryRectangle(RasterContext &context, GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2) {
  if (context.listMode != 0 && context.list->beginPrimitive(context, GL_QUADS)) {
    addRectangle(context.list->recorder(), x1, y1, x2, y2);
    context.list->endPrimitive(context);
    return true;
  }
  if (!isCandidate(context) || !beginPrimitive(context, rectangleMode(context)))
    return false;
  addRectangle(context.software->recorder, x1, y1, x2, y2);
  endPrimitive(context);
  return true;
}

void hostReads(RasterContext &context, const char *name) {
  if (context.software)
    context.software->habits.readsPixels = true;
  hostWaits(context, name);
}

void hostWaits(RasterContext &context, const char *name) {
  withinMemory(context, name, [&] {
    if (executesPixels(context) && context.software)
      context.software->residency.synchronise(name);
  });
}

void hostTakesColor(RasterContext &context) {
  if (executesPixels(context))
    settleCurrentValues(*context.host);
}

void hostWrites(RasterContext &context, const char *name) {
  withinMemory(context, name, [&] {
    if (executesPixels(context) && context.software)
      context.software->hostDraws(name);
  });
}

void hostDoesUnknown(RasterContext &context, const char *name) {
  withinMemory(context, name, [&] {
    if (!executesPixels(context))
      return;
    if (context.software)
      context.software->residency.hostDoesAnything(name);
    // The command may draw, too.
    if ((context.attention & attention::kParameters) != 0)
      (void)validate(context);
  });
}

} // namespace arbiter::state
