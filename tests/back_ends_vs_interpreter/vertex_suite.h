#pragma once
#include "subject.h"
#include "suite.h"

namespace arbiter::differential {

/// Tests generated vertex programs, with one vertex for each pixel. A fragment program shows one or
/// two results as colors; the place and depth of the point show the position.
[[nodiscard]] Report runVertexSuite(Backend &backend, const SuiteOptions &options);

/// Tests each opcode of vertex programs on special values, array rows at addresses far outside, and
/// a user clip plane.
[[nodiscard]] Report runVertexEdges(Backend &backend, const SuiteOptions &options);

} // namespace arbiter::differential
