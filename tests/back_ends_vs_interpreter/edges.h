#pragma once
#include "suite.h"

namespace arbiter::differential {

/// Tests every arithmetic opcode, with and without _SAT, and KIL, on all pairs of special values
/// (zeros, infinities, NaN, denormals, huge numbers). The values are read from a texture, so that
/// no compiler knows them. Results are compared with ir/semantics.h by kind of value: NaN, infinity
/// and its sign, number within tolerance. One "program" of the report is one opcode in one form.
[[nodiscard]] Report runEdges(Backend &backend, const SuiteOptions &options);

} // namespace arbiter::differential
