#pragma once
#include <epoxy/gl.h>

#include "fp_compiler/combiners/state.h"
#include "fp_compiler/testing/evaluate_combiners.h"

namespace combined {

/// Sets the register combiners of the current context to the state, for the active general stages.
void issue(const arbiter::fp::combiners::State &state);
/// Sets the constant colors of that many stages.
void issueConstants(const arbiter::fp::combiners::Inputs &inputs, int stages);

} // namespace combined
