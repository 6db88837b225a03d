#pragma once
#include <string>
#include <vector>

#include "fp_compiler/ir/interface.h"
#include "state/objects/program_object.h"

/// Defines results that a fragment program reads but its vertex program does not write: as (0, 0,
/// 0, 1), like the rasterizer. Otherwise they would be whatever the host's memory holds. For
/// fixed-function fragments, hosts use the vertex's current values themselves.
namespace arbiter::state {

/// Returns the results that a pair lacks.
[[nodiscard]] std::vector<fp::ir::Output> missingResults(const CompiledProgram &vertex,
                                                         const CompiledProgram &fragment);
/// Returns the vertex program with these results defined.
[[nodiscard]] fp::ir::Program withResults(fp::ir::Program vertex,
                                          const std::vector<fp::ir::Output> &missing);
/// Returns its GLSL with these results defined; empty if none is missing.
[[nodiscard]] std::string glslWithResults(const CompiledProgram &vertex,
                                          const std::vector<fp::ir::Output> &missing);

} // namespace arbiter::state
