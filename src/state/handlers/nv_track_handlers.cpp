// Matrix tracking of program parameters (NV_vertex_program 2.14.5, 6.1.13), and MatrixMode of
// matrices that serve nothing else.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/imaging/imaging_state.h"
#include "state/lists/list_compiler.h"
#include "state/pixel_commands/imaging_commands.h"
#include "state/programs/nv/matrix_tracking.h"
#include "state/programs/nv/nv_programs.h"
#include "state/programs/nv/nv_state.h"
#include "state/programs/program_bind.h"

namespace arbiter::state::handlers {

void TrackMatrixNV(Context &context, GLenum target, GLuint address, GLenum matrix,
                   GLenum transform) {
  if (!outsideBeginEnd(context, "TrackMatrix between Begin and End"))
    return;
  if (context.listMode)
    return listCompiler(context).record(context, {.kind = Command::Kind::TrackMatrix,
                                                  .target = target,
                                                  .name = address,
                                                  .object = matrix,
                                                  .format = transform});
  trackMatrix(context, target, address, matrix, transform);
}

void GetTrackMatrixivNV(Context &context, GLenum target, GLuint address, GLenum pname,
                        GLint *params) {
  if (!outsideBeginEnd(context, "GetTrackMatrix between Begin and End"))
    return;
  const bool matrix = pname == GL_TRACK_MATRIX_NV;
  if (target != GL_VERTEX_PROGRAM_NV || (!matrix && pname != GL_TRACK_MATRIX_TRANSFORM_NV))
    return raise(context, GL_INVALID_ENUM, "GetTrackMatrix: target or pname");
  if (!mayBeTracked(context, address))
    return raise(context, GL_INVALID_VALUE, "GetTrackMatrix: address");
  const TrackedMatrix &tracked = context.nv->tracked[address / 4];
  if (params)
    *params = GLint(matrix ? tracked.matrix : tracked.transform);
}

void MatrixMode(Context &context, GLenum mode) {
  // MATRIXi_NV are the ARB's program matrices, as in NVIDIA's driver.
  const GLuint number = mode - GL_MATRIX0_NV;
  const GLenum named = context.nv && number < 8 ? GL_MATRIX0_ARB + number : mode;
  // The layer executes COLOR and the mode that ends it. In a list that is only known when the list
  // is called.
  const bool colors =
      context.imaging && (mode == GL_COLOR || context.imaging->colorMatrix.isUsed());
  if (!colors || context.insideBeginEnd)
    return context.host->MatrixMode(named);
  context.imaging->colorMatrix.noteUse();
  if (mode == GL_COLOR || context.listMode != 0 || context.imaging->colorMatrix.isCurrent(context))
    return issueImaging(context, {.kind = ImagingCommand::Kind::MatrixMode, .pname = named});
  context.host->MatrixMode(named);
}

} // namespace arbiter::state::handlers
