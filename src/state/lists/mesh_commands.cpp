#include "state/lists/mesh_commands.h"

#include <cstdint>
#include <utility>

#include "host/host_table.h"
#include "state/host_draw/evaluators/evaluation.h"
#include "state/host_draw/prepare_draw.h"
#include "state/lists/list_compiler.h"
#include "state/lists/primitive_commands.h"
#include "state/raster_draw/commands.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

/// Draws one primitive of the mesh; `points` evaluates. Returns false after an error of Begin.
template <typename Points> bool primitive(RasterContext &context, GLenum mode, Points &&points) {
  issueBegin(context, mode);
  if (!context.insideBeginEnd)
    return false;
  points();
  issueEnd(context);
  return true;
}

/// Draws the mesh as 5.1 says: FILL is a strip for each step in v. The counters may exceed GLint.
void drawMesh(RasterContext &context, const EvaluatorMesh &mesh) {
  const auto point = [&](std::int64_t u, std::int64_t v) {
    evaluatePoint(context, {mesh.dimension, true, GLdouble(u), GLdouble(v)});
  };
  const auto along = [&](std::int64_t v) {
    for (std::int64_t u = mesh.u1; u <= mesh.u2; ++u)
      point(u, v);
  };
  if (mesh.mode == GL_POINT) {
    (void)primitive(context, GL_POINTS, [&] {
      for (std::int64_t v = mesh.v1; v <= mesh.v2; ++v)
        along(v);
    });
    return;
  }
  bool drawn = true;
  for (std::int64_t v = mesh.v1; drawn && mesh.mode == GL_LINE && v <= mesh.v2; ++v)
    drawn = primitive(context, GL_LINE_STRIP, [&] { along(v); });
  for (std::int64_t u = mesh.u1;
       drawn && mesh.mode == GL_LINE && mesh.dimension == 2 && u <= mesh.u2; ++u)
    drawn = primitive(context, GL_LINE_STRIP, [&] {
      for (std::int64_t v = mesh.v1; v <= mesh.v2; ++v)
        point(u, v);
    });
  for (std::int64_t v = mesh.v1; drawn && mesh.mode == GL_FILL && v < mesh.v2; ++v)
    drawn = primitive(context, GL_QUAD_STRIP, [&] {
      for (std::int64_t u = mesh.u1; u <= mesh.u2; ++u) {
        point(u, v);
        point(u, v + 1);
      }
    });
}

/// Draws or records the mesh. Returns false, after preparing a draw, if it is the host's.
bool takesMesh(RasterContext &context, const EvaluatorMesh &mesh) {
  if (context.mapsNamed && !context.insideBeginEnd) {
    if (context.listMode != 0) {
      Command command{.kind = Command::Kind::EvalMesh, .target = mesh.mode, .name = mesh.dimension};
      const GLint range[] = {mesh.u1, mesh.u2, mesh.v1, mesh.v2};
      command.bytes.assign(reinterpret_cast<const char *>(range), sizeof range);
      listCompiler(context).record(context, std::move(command));
      return true;
    }
    if (mayEvaluate(context) && mesh.hasMode()) {
      drawMesh(context, mesh);
      return true;
    }
  }
  if (context.attention && !prepareDraw(context, mesh.mode == GL_POINT ? GL_POINTS : GL_LINES))
    return true;
  if (context.softwareListens)
    hostWrites(context, mesh.dimension == 1 ? "glEvalMesh1" : "glEvalMesh2");
  ++*context.drawCounter;
  return false;
}

} // namespace

void issueEvalMesh(RasterContext &context, const EvaluatorMesh &mesh) {
  if (takesMesh(context, mesh))
    return;
  if (mesh.dimension == 1)
    context.host->EvalMesh1(mesh.mode, mesh.u1, mesh.u2);
  else
    context.host->EvalMesh2(mesh.mode, mesh.u1, mesh.u2, mesh.v1, mesh.v2);
}

} // namespace arbiter::state
