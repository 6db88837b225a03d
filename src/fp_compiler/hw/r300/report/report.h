#pragma once
#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/r300/machine.h"

namespace arbiter::fp::hw::r300 {

/// Returns the counts of GL_PROGRAM_NATIVE_*_ARB. Fast: makes no strings.
[[nodiscard]] ResourceCounts counts(const Code &code);

/// Sets reasons, costs, nodes and the chain of dependent reads.
/// \param code what compile() made of the program
void report(NativeReport &report, const ir::Program &program, const Code &code);

} // namespace arbiter::fp::hw::r300
