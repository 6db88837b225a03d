#pragma once
#include "fp_compiler/testing/evaluate_combiners.h"

/// The equations of section 3.8.12 by Numerics::Fx9, in integers, where evaluate() has them in real
/// numbers.
namespace arbiter::fp::combiners {

/// The colour is of whole 255ths. The margin is how far, in 255ths, what the fragment is given was
/// from being rounded to another number.
[[nodiscard]] Evaluated evaluateFx9(const State &state, const Inputs &inputs);

} // namespace arbiter::fp::combiners
