#pragma once
#include <string>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::glsl {

/// The functions that the expressions of a program's opcodes call: arb_address() for ARL,
/// arb_log() for LOG.
[[nodiscard]] std::string helpers(const ir::Program &program);

} // namespace arbiter::fp::glsl
