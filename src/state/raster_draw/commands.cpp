#include "state/raster_draw/commands.h"

#include "host/host_table.h"
#include "state/core/memory.h"
#include "state/host_draw/draw.h"
#include "state/lists/list_compiler.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/replay.h"

namespace arbiter::state::software {

namespace {

/// Nothing of ours can be concerned: the command is an error, or is compiled, or everything is the
/// host's since the list was begun.
bool isHosts(Context &context) {
  if (context.listMode != 0)
    context.list->notePixels();
  return context.insideBeginEnd || context.listMode != 0;
}

/// The draw is looked at: it is executed now, programs are valid, and the rasterizer is used.
bool isTried(Context &context) {
  return !isHosts(context) && validatePrograms(context) && context.softwarePossible;
}

bool isIndexType(GLenum type) {
  return type == GL_UNSIGNED_INT || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_BYTE;
}

} // namespace

bool draw(Context &context, const DrawCommand &command) {
  if (isHosts(context))
    return false;
  if (command.mode > GL_POLYGON || command.count <= 0 || command.first < 0 ||
      (command.indexType != 0 && !isIndexType(command.indexType)))
    return false;
  return isTried(context) && drawArrays(context, command);
}

bool drawRange(Context &context, GLuint start, GLuint end, const DrawCommand &command) {
  return end >= start && draw(context, command);
}

bool multiDrawArrays(Context &context, GLenum mode, const GLint *first, const GLsizei *count,
                     GLsizei drawCount) {
  if (isHosts(context))
    return false;
  if (mode > GL_POLYGON || drawCount <= 0 || !first || !count)
    return false;
  for (GLsizei i = 0; i < drawCount; ++i)
    if (first[i] < 0 || count[i] < 0)
      return false;
  if (!isTried(context))
    return false;
  for (GLsizei i = 0; i < drawCount; ++i)
    if (count[i] > 0 && !drawArrays(context, {mode, first[i], count[i]}))
      context.host->DrawArrays(mode, first[i], count[i]);
  return true;
}

bool multiDrawElements(Context &context, GLenum mode, const GLsizei *count, GLenum type,
                       const void *const *indices, GLsizei drawCount, const GLint *baseVertices) {
  if (isHosts(context))
    return false;
  if (mode > GL_POLYGON || drawCount <= 0 || !count || !indices || !isIndexType(type))
    return false;
  for (GLsizei i = 0; i < drawCount; ++i)
    if (count[i] < 0)
      return false;
  if (!isTried(context))
    return false;
  for (GLsizei i = 0; i < drawCount; ++i) {
    const GLint base = baseVertices ? baseVertices[i] : 0;
    if (count[i] == 0 || drawArrays(context, {mode, 0, count[i], type, indices[i], base}))
      continue;
    if (baseVertices)
      context.host->DrawElementsBaseVertex(mode, count[i], type, indices[i], base);
    else
      context.host->DrawElements(mode, count[i], type, indices[i]);
  }
  return true;
}

namespace {

/// In the order of section 2.10.
void addRectangle(ImmediateRecorder &to, GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2) {
  to.vertex(x1, y1, 0, 1);
  to.vertex(x2, y1, 0, 1);
  to.vertex(x2, y2, 0, 1);
  to.vertex(x1, y2, 0, 1);
}

} // namespace

bool rectangle(Context &context, GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2) {
  if (context.listMode != 0 && context.list->beginPrimitive(context, GL_QUADS)) {
    addRectangle(context.list->recorder(), x1, y1, x2, y2);
    context.list->endPrimitive(context);
    return true;
  }
  if (!isTried(context) || !begin(context, GL_POLYGON))
    return false;
  addRectangle(context.software->recorder, x1, y1, x2, y2);
  end(context);
  return true;
}

void hostReads(Context &context, const char *name) {
  withinMemory(context, name, [&] {
    if (!isHosts(context) && context.software)
      context.software->residency.synchronise(name);
  });
}

void hostWrites(Context &context, const char *name) {
  withinMemory(context, name, [&] {
    if (!isHosts(context) && context.software)
      context.software->hostDraws(name);
  });
}

void hostDoesUnknown(Context &context, const char *name) {
  withinMemory(context, name, [&] {
    if (isHosts(context))
      return;
    if (context.software)
      context.software->residency.hostDoesAnything(name);
    // It may draw, too.
    if ((context.attention & attention::kParameters) != 0)
      (void)validate(context);
  });
}

} // namespace arbiter::state::software
