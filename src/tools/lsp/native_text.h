#pragma once
#include <string>

#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/profile.h"

/// A card's counts in few words.
namespace arbiter::tools::lsp {

/// "2 slots", "1 slot, 1 TEX", "no slot"; half of a shared pair is "0.5 slots".
[[nodiscard]] std::string costText(double slots, std::uint32_t textures);

/// "alone on r300: 2 slots": what one instruction of the opcode takes, found by compiling a program
/// of it for the profile; empty where the profile has no model of the chip.
[[nodiscard]] std::string costOfOpcode(fp::ir::Opcode op, const fp::hw::Profile &profile);

/// True if the program by which costOfOpcode() finds out is one.
[[nodiscard]] bool opcodeLoads(fp::ir::Opcode op, const fp::hw::Profile &profile);

} // namespace arbiter::tools::lsp
