#pragma once
#include <string>

#include "state/programs/program_object.h"

namespace arbiter::state {

/// The vertex program's GLSL for a pair with this fragment program, where that one reads results
/// that the vertex program does not write: with the missing ones defined as (0, 0, 0, 1), as the
/// rasterizer has them. Left alone they are whatever the host's memory holds. Empty where nothing
/// is missing. Before fixed function hosts take the vertex's current values themselves.
[[nodiscard]] std::string withMissingResults(const CompiledProgram &vertex,
                                             const CompiledProgram &fragment);

} // namespace arbiter::state
