#pragma once
#include "subject.h"
#include "suite.h"

namespace arbiter::differential {

/// Generated vertex programs, one vertex a pixel: a fragment program shows one or two of a
/// program's results as colours, and where the point lands and its depth show the position.
[[nodiscard]] Report runVertexSuite(Backend &backend, const SuiteOptions &options);

/// Each opcode of vertex programs on special values, rows by addresses far outside their array, and
/// a user clip plane.
[[nodiscard]] Report runVertexEdges(Backend &backend, const SuiteOptions &options);

} // namespace arbiter::differential
