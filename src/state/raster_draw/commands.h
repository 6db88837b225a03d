#pragma once
#include "state/host_draw/evaluators/nv_attributes.h"
#include "state/host_draw/native_inputs.h"
#include "state/mirror/attribute_aliases.h"
#include "state/mirror/convert.h"
#include "state/primitives/recorder.h"
#include "state/raster_draw/bitmap.h"
#include "state/raster_draw/draw.h"
#include "state/raster_draw/raster_context.h"

/// The functions that generated entry points call before a command goes to the host
/// (src/dispatch/software.toml).
namespace arbiter::state {

// --- Draws that the rasterizer may do. They return true if drawn. They are called only if
// mayDraw(), before anything is prepared for the host's draw. ---

/// True if the rasterizer is in use or listens, or if a program change may start it.
[[nodiscard]] inline bool mayDraw(const RasterContext &context) {
  return context.softwareListens ||
         (!context.passThrough && (context.attention & attention::kProgram) != 0);
}
[[nodiscard]] bool tryRectangle(RasterContext &context, GLfloat x1, GLfloat y1, GLfloat x2,
                                GLfloat y2);

// --- Preparations for a host command called `name`. They do nothing between Begin and End, where
// these commands are errors, and while a list is compiled, where nothing is executed. ---

void hostReads(RasterContext &context, const char *name);
void hostWaits(RasterContext &context, const char *name);
/// Prepares ColorMaterial (host_draw/current_values.h).
void hostTakesColor(RasterContext &context);
void hostWrites(RasterContext &context, const char *name);
void hostDoesUnknown(RasterContext &context, const char *name);

// --- While a primitive is recorded ---

/// Records a generic attribute; attribute 0 makes a vertex.
inline void generic(ContextHot &hot, GLuint index, GLfloat x, GLfloat y, GLfloat z, GLfloat w,
                    unsigned given) {
  if (index == 0)
    hot.recorder->vertex(x, y, z, w, given);
  else if (hot.attributesAlias && isAliasedRegister(index)) [[unlikely]]
    setAliasedAttribute(hot, index, {x, y, z, w}, given);
  else
    hot.recorder->set(kGeneric0 + int(index), x, y, z, w, given);
}

} // namespace arbiter::state
