// Vertex array objects. If the layer implements APPLE_vertex_array_object, its objects share one
// name space with the host's (state/era/vertex_array_objects.h). Lists never hold these commands
// (OpenGL 3.0, 5.4).
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/era/era_state.h"

namespace arbiter::state {

namespace {

/// Returns the layer's objects. Null if it has none, or if the command is an error, which the host
/// raises.
VertexArrayObjects *objectsOf(Context &context) {
  return context.era && context.era->offered.vertexArrayObject && !context.insideBeginEnd
             ? &context.era->vertexArrays
             : nullptr;
}

} // namespace

namespace handlers {

void BindVertexArrayAPPLE(Context &context, GLuint array) {
  if (!context.era || !context.era->offered.vertexArrayObject)
    return context.host->BindVertexArrayAPPLE(array);
  if (outsideBeginEnd(context, "BindVertexArray between Begin and End"))
    context.era->vertexArrays.bindApple(context, context.era->client.range, array);
}

void BindVertexArray(Context &context, GLuint array) {
  if (VertexArrayObjects *const objects = objectsOf(context))
    objects->bind(context, context.era->client.range, array);
  else
    context.host->BindVertexArray(array);
}

void GenVertexArrays(Context &context, GLsizei n, GLuint *arrays) {
  context.host->GenVertexArrays(n, arrays);
  if (const VertexArrayObjects *const objects = objectsOf(context); objects && arrays)
    objects->renameTaken(context, n, arrays);
}

void DeleteVertexArrays(Context &context, GLsizei n, const GLuint *arrays) {
  if (VertexArrayObjects *const objects = objectsOf(context); objects && arrays)
    objects->remove(context, context.era->client.range, n, arrays);
  context.host->DeleteVertexArrays(n, arrays);
}

GLboolean IsVertexArray(Context &context, GLuint array) {
  const VertexArrayObjects *const objects = objectsOf(context);
  return objects && objects->has(array) ? GLboolean(GL_TRUE) : context.host->IsVertexArray(array);
}

} // namespace handlers
} // namespace arbiter::state
