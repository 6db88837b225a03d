#pragma once
#include "fp_compiler/hw/r300/compile.h"
#include "fp_compiler/hw/r300/lower/emitter.h"

namespace arbiter::fp::hw::r300 {

/// Lowers a program to operations, in the program's order. Special values differ from
/// ir/semantics.h. SGE and SLT compare by the sign of a difference, so NaN counts as not below. POW
/// and LIT give infinity if the base is zero and the exponent below zero. POW of a base below zero
/// is NaN. LRP is c + a*(b-c). SIN, COS and SCS reduce the angle by FRC and stay within 2^-9.
void lower(const ir::Program &program, const CompileOptions &options, Flow &flow);

} // namespace arbiter::fp::hw::r300
