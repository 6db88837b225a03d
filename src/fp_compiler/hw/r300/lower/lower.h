#pragma once
#include "fp_compiler/hw/r300/compile.h"
#include "fp_compiler/hw/r300/lower/emitter.h"

namespace arbiter::fp::hw::r300 {

/// Makes a program's operations, in the program's order. Departures from ir/semantics.h for special
/// values: SGE and SLT compare by the sign of a difference, so that NaN counts as not below; a POW
/// or LIT whose base is zero under an exponent below zero is an infinity, a POW of a base below
/// zero is NaN; LRP is c + a*(b-c). SIN, COS and SCS reduce the angle by FRC and stay within 2^-9.
void lower(const ir::Program &program, const CompileOptions &options, Flow &flow);

} // namespace arbiter::fp::hw::r300
