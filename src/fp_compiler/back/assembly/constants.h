#pragma once
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::assembly {

/// True for an operand that only SWZ can express: 0, 1, or differing signs.
[[nodiscard]] bool isExtended(const ir::Operand &operand);

/// Returns the program with what its extended operands read of constants as constants themselves,
/// so that SWZ reads none. Mesa's parser finds a constant of four equal numbers as one component of
/// another constant, and SWZ then reads the other components (22.3.6).
[[nodiscard]] ir::Program withPlainConstants(ir::Program program);

} // namespace arbiter::fp::assembly
