#pragma once
#include "fp_compiler/front/nv/code.h"

namespace arbiter::fp::nv {

/// Writes an instruction. If the IR lacks its opcode (FP_NV_WORD in ops.def), writes it with other
/// opcodes. Its operands are those of the text, and _SAT is the destination's.
void writeInstruction(Code &code, const ir::Instruction &instruction);

/// Returns the components that an instruction under NVIDIA's options writes, out of those in its
/// mask. RFL does not write w, and SCS does not write z and w.
[[nodiscard]] std::uint8_t writtenBy(const ir::Instruction &instruction);

/// Returns the nearest integers, halves to even.
[[nodiscard]] ir::Operand rounded(Code &code, const ir::Operand &value);

} // namespace arbiter::fp::nv
