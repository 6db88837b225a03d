#pragma once
#include <string>

#include "fp_compiler/hw/r300/machine.h"

/// Words the reasons for the slots, constants and interpolants of a Code.
namespace arbiter::fp::hw::r300 {

/// How many slots an instruction takes for itself, and why.
enum class Extent : std::uint8_t {
  OneSlot,
  HalvesApart, ///< one operation for RGB and one for alpha, in two slots
  Expansion,
};

/// Returns the reason for an ALU slot.
[[nodiscard]] std::string aluText(const ir::Program &program, std::uint16_t origin, Cause cause,
                                  Extent extent);

[[nodiscard]] std::string constantText(const ir::Program &program, const Constant &constant);

/// Returns "fragment.texcoord[3]", or the name of what an option reads.
[[nodiscard]] std::string interpolantName(const ir::Program &program, std::uint16_t attribute);

/// True if the unit can read the operand directly: its selects and signs are a native swizzle of
/// one pair, for the components that matter. The alpha half takes any component.
[[nodiscard]] bool isNative(const ir::Instruction &instruction, int operand);

} // namespace arbiter::fp::hw::r300
