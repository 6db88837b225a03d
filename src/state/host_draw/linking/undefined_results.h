#pragma once
#include <string>
#include <vector>

#include "fp_compiler/ir/interface.h"
#include "state/objects/program_object.h"

/// Results that a fragment program reads and its vertex program does not write are (0, 0, 0, 1), as
/// the rasterizer has them. Left alone they are whatever the host's memory holds. Before fixed
/// function hosts take the vertex's current values themselves.
namespace arbiter::state {

/// The results that are missing in a pair.
[[nodiscard]] std::vector<fp::ir::Output> missingResults(const CompiledProgram &vertex,
                                                         const CompiledProgram &fragment);
/// The vertex program with these defined.
[[nodiscard]] fp::ir::Program withResults(fp::ir::Program vertex,
                                          const std::vector<fp::ir::Output> &missing);
/// The same of its GLSL; empty where nothing is missing.
[[nodiscard]] std::string glslWithResults(const CompiledProgram &vertex,
                                          const std::vector<fp::ir::Output> &missing);

} // namespace arbiter::state
