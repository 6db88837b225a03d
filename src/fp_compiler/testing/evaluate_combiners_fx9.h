#pragma once
#include "fp_compiler/testing/evaluate_combiners.h"

/// Computes the equations of section 3.8.12 by Numerics::Fx9, in integers. evaluate() uses real
/// numbers.
namespace arbiter::fp::combiners {

/// Computes the colour of a fragment, in whole 255ths. The margin is the smallest distance of an
/// input, in 255ths, from rounding to another number.
[[nodiscard]] Evaluated evaluateFx9(const State &state, const Inputs &inputs);

} // namespace arbiter::fp::combiners
