#pragma once
#include <string>
#include <vector>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::ir {

/// Checks what the IR promises to passes and back ends: indices within their tables, masks and
/// swizzles in range, files in allowed places, one target for each image unit, tables without
/// duplicate outputs. Returns one line for each violation, with the instruction's number; empty if
/// there is none. It shares no code with the front end, so that neither hides the other's mistakes.
[[nodiscard]] std::vector<std::string> validate(const Program &program);

} // namespace arbiter::fp::ir
