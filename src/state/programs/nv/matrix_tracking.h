#pragma once
#include <GL/gl.h>

/// Program parameters that track GL's matrices (NV_vertex_program 2.14.5). They have the matrices'
/// values at the time they are read.
namespace arbiter::state {

struct ProgramContext;

/// True if four parameters from `address` on may track a matrix: a multiple of four, within the
/// number of parameters.
[[nodiscard]] bool mayBeTracked(const ProgramContext &context, GLuint address);

/// Executes TrackMatrixNV: c[address] to c[address + 3] track the rows of the matrix from now on.
/// With NONE they keep their last values.
/// \error INVALID_ENUM for target, matrix or transform; INVALID_VALUE for address
void trackMatrix(ProgramContext &context, GLenum target, GLuint address, GLenum matrix,
                 GLenum transform);

/// Updates the parameters in c[] that track matrices. Requires that the context is current, with no
/// open primitive. It only takes a test if none is tracked.
void refreshTrackedMatrices(ProgramContext &context);

} // namespace arbiter::state
