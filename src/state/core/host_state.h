#pragma once
#include <GL/gl.h>

#include "fp_compiler/ir/interface.h"

namespace arbiter::state {

class Context;

/// The value of one row of GL state (3.11.3.2), from the host.
void fetchState(Context &context, const fp::ir::StateRef &state, GLfloat value[4]);
/// All rows of the matrix that a row of state is of, its modifier applied.
void fetchMatrix(Context &context, const fp::ir::StateRef &state, GLfloat rows[4][4]);

} // namespace arbiter::state
