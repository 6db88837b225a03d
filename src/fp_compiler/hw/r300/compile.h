#pragma once
#include "fp_compiler/hw/r300/machine.h"

namespace arbiter::fp::hw::r300 {

struct CompileOptions {
  /// Rectangle textures take [0,1] coordinates, so a MUL comes before each such sample.
  bool scaleRectangles = false;
};

/// Compiles a fragment program for the chip: expands opcodes, legalises operands, renames, builds
/// nodes, schedules pairs, allocates registers. Never fails: a program that does not fit gives code
/// that is too long. Drops dead code and propagates copies, as the drivers did.
/// Requires: a program of a fragment language that ir::validate() accepts.
[[nodiscard]] Code compile(const ir::Program &program, const CompileOptions &options);

} // namespace arbiter::fp::hw::r300
