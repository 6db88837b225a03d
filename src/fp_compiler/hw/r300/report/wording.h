#pragma once
#include <string>

#include "fp_compiler/hw/r300/machine.h"

/// Why things stand in a Code, in words.
namespace arbiter::fp::hw::r300 {

/// How many slots of its own an instruction has, and why.
enum class Extent : std::uint8_t {
  OneSlot,
  HalvesApart, ///< one operation for RGB and one for alpha, in two slots
  Expansion,
};

/// Of an ALU slot.
[[nodiscard]] std::string aluText(const ir::Program &program, std::uint16_t origin, Cause cause,
                                  Extent extent);

[[nodiscard]] std::string constantText(const ir::Program &program, const Constant &constant);

/// "fragment.texcoord[3]", or what an option reads
[[nodiscard]] std::string interpolantName(const ir::Program &program, std::uint16_t attribute);

/// The unit has the operand as it is: what it selects among the components that matter, with its
/// signs, is a native swizzle of one pair (the alpha half takes any component).
[[nodiscard]] bool isNative(const ir::Instruction &instruction, int operand);

} // namespace arbiter::fp::hw::r300
