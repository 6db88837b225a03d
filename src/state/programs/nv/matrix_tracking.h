#pragma once
#include <GL/gl.h>

/// Program parameters that follow GL's matrices (NV_vertex_program 2.14.5): their values are those
/// of the matrices at the moment that they are read.
namespace arbiter::state {

class Context;

/// Four parameters from `address` on may follow a matrix: it is a multiple of four, below their
/// number.
[[nodiscard]] bool mayBeTracked(const Context &context, GLuint address);

/// TrackMatrixNV: c[address] to c[address + 3] are the rows of the
/// matrix from now on; with NONE they keep what they had last.
/// \error INVALID_ENUM target, matrix or transform; INVALID_VALUE address
void trackMatrix(Context &context, GLenum target, GLuint address, GLenum matrix, GLenum transform);

/// Brings c[] up to date with the matrices that it follows. The context is current, and outside of
/// Begin and End. Costs a test where it follows none.
void refreshTrackedMatrices(Context &context);

} // namespace arbiter::state
