#pragma once
#include <string>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/jit.h"
#include "util/result.h"

namespace arbiter::tools {

struct MachineCodeError {
  std::string message;
};

/// The code that the rasterizer's engine makes of a program on this processor. A fragment program's
/// is for rows of an RGBA8 target; its units hold RGBA8 textures, unfiltered, clamped to the edge.
/// Errors: no engine, arithmetic or a program that it has no code for.
[[nodiscard]] Result<std::string, MachineCodeError>
machineCode(const fp::ir::Program &program, fp::Numerics numerics, fp::jit::Listing what);

} // namespace arbiter::tools
