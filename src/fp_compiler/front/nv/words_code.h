#pragma once
#include "fp_compiler/front/nv/code.h"

namespace arbiter::fp::nv {

/// Writes an instruction whose opcode may be one of ops.def's words, in terms of the others. Its
/// operands are those of the text; _SAT is the destination's.
void writeInstruction(Code &code, const ir::Instruction &instruction);

/// The components that an instruction under NVIDIA's options writes of those in its mask: RFL
/// leaves w alone, and SCS z and w.
[[nodiscard]] std::uint8_t writtenBy(const ir::Instruction &instruction);

/// The nearest integers, halves to even.
[[nodiscard]] ir::Operand rounded(Code &code, const ir::Operand &value);

} // namespace arbiter::fp::nv
