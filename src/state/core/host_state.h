#pragma once
#include <GL/gl.h>

#include "fp_compiler/ir/interface.h"

namespace arbiter::state {

struct CoreContext;

/// Queries the host for one row of GL state (3.11.3.2).
void fetchState(CoreContext &context, const fp::ir::StateRef &state, GLfloat value[4]);
/// Queries all rows of the matrix that a row of state belongs to, with its modifier applied.
void fetchMatrix(CoreContext &context, const fp::ir::StateRef &state, GLfloat rows[4][4]);

} // namespace arbiter::state
