#pragma once
#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/r300/machine.h"

namespace arbiter::fp::hw::r300 {

/// The counts of GL_PROGRAM_NATIVE_*_ARB. Fast: no strings.
[[nodiscard]] ResourceCounts counts(const Code &code);

/// Reasons, costs, nodes and the chain of dependent reads. `code` is compile()'s of the program.
void report(NativeReport &report, const ir::Program &program, const Code &code);

} // namespace arbiter::fp::hw::r300
