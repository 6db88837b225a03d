#pragma once
#include <string>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/jit.h"
#include "util/result.h"

namespace arbiter::tools {

struct MachineCodeError {
  std::string message;
};

/// Returns a listing of the rasterizer's machine code for a program on this processor. A fragment
/// program is compiled for rows of an RGBA8 target. Its units hold unfiltered RGBA8 textures,
/// clamped to the edge. Fails if there is no code generator, or if it does not support the
/// arithmetic or the program.
[[nodiscard]] Result<std::string, MachineCodeError>
machineCode(const fp::ir::Program &program, fp::Numerics numerics, fp::jit::Listing what);

} // namespace arbiter::tools
