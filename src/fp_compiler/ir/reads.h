#pragma once
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"

/// Which components an instruction reads and writes: the facts that dead code, printing and
/// emission share. A component mask has bit 0 for x to bit 3 for w.
namespace arbiter::fp::ir {

/// Components of the coordinate that a texture target consumes, without TXP's divisor and TXB's
/// bias (w). Shadow targets compare with z; Shadow1D leaves y alone.
[[nodiscard]] std::uint8_t coordinateMask(TexTarget target);

/// True for the targets whose sample is a comparison (ARB_fragment_program_shadow).
[[nodiscard]] bool isShadow(TexTarget target);

/// Operand components (before the swizzle) that matter to the components in the destination's
/// mask; all four for KIL, bit 0 for a scalar operand, 0 for one that is not read at all.
[[nodiscard]] std::uint8_t operandMask(const Instruction &instruction, int operand);

/// Register components that operandMask() reaches through the swizzle (Zero and One reach none).
[[nodiscard]] std::uint8_t registerMask(const Instruction &instruction, int operand);

/// Components of a result that count: z of a depth, x of a fog coordinate or point size, else all.
[[nodiscard]] std::uint8_t resultMask(OutputKind kind);

/// For each temporary, whether some instruction reads a component before any has written it: those
/// must start at zero.
[[nodiscard]] std::vector<bool> readsUnwritten(const Program &program);

/// Components written: the destination's mask, none for KIL.
[[nodiscard]] std::uint8_t writeMask(const Instruction &instruction);

} // namespace arbiter::fp::ir
