#pragma once
#include "fp_compiler/ir/ir.h"

/// The parts of programs that the rules of advice and the debugger name most.
namespace arbiter::tools {

using fp::ir::AttributeKind;
using fp::ir::File;
using fp::ir::Instruction;
using fp::ir::Opcode;
using fp::ir::Operand;
using fp::ir::Program;
using fp::ir::Select;
using fp::ir::StateItem;
using fp::ir::Vec4;

} // namespace arbiter::tools
