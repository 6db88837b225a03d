#pragma once
#include "fp_compiler/ir/ir.h"

/// The parts of programs that the passes name most.
namespace arbiter::fp::opt {

using ir::File;
using ir::Instruction;
using ir::Opcode;
using ir::Operand;
using ir::Select;

} // namespace arbiter::fp::opt
