#pragma once
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"

/// Finds which components an instruction reads and writes. Dead-code elimination, printing and code
/// generation share these facts. A component mask has bit 0 for x to bit 3 for w.
namespace arbiter::fp::ir {

/// Returns the components of the coordinate that a texture target uses, without w for TXP's divisor
/// and TXB's bias. Shadow targets compare with z; Shadow1D does not use y.
[[nodiscard]] std::uint8_t coordinateMask(TexTarget target);

/// True for targets whose sample is a comparison (ARB_fragment_program_shadow).
[[nodiscard]] constexpr bool isShadow(TexTarget target) {
  return target == TexTarget::Shadow1D || target == TexTarget::Shadow2D ||
         target == TexTarget::ShadowRect;
}

/// Returns the operand components, before the swizzle, that affect the components in the
/// destination's mask. KIL gives all four, a scalar operand bit 0, and an unread operand 0.
[[nodiscard]] std::uint8_t operandMask(const Instruction &instruction, int operand);

/// Returns the register components that operandMask() reads through the swizzle. Zero and One read
/// none.
[[nodiscard]] std::uint8_t registerMask(const Instruction &instruction, int operand);

/// Returns the components of a result that count: z of a depth, x of a fog coordinate or point
/// size, otherwise all.
[[nodiscard]] std::uint8_t resultMask(OutputKind kind);

/// Returns for each temporary whether a component may be read before it is written. Such a
/// temporary must start at zero.
[[nodiscard]] std::vector<bool> readsUnwritten(const Program &program);

/// Returns the components written: the destination's mask, or none for KIL.
[[nodiscard]] std::uint8_t writeMask(const Instruction &instruction);

} // namespace arbiter::fp::ir
