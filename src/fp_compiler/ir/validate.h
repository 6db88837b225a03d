#pragma once
#include <string>
#include <vector>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::ir {

/// Checks a program against what the IR promises to passes and back ends: indices in their tables,
/// masks and swizzles in range, files where they may stand, one target for each image unit, tables
/// without duplicate outputs. Returns one line for each breach, with the instruction's number;
/// empty if there is none. Written apart from the front end, so that neither hides the other's
/// mistakes.
[[nodiscard]] std::vector<std::string> validate(const Program &program);

} // namespace arbiter::fp::ir
