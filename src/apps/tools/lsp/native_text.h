#pragma once
#include <string>

#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/profile.h"

/// Words a card's costs briefly.
namespace arbiter::tools::lsp {

/// Returns "2 slots", "1 slot, 1 TEX" or "no slot". Half of a shared pair is "0.5 slots".
[[nodiscard]] std::string costText(double slots, std::uint32_t textures);

/// Returns the cost of one instruction, such as "alone on r300: 2 slots". Compiles a program with
/// only this instruction for the profile. Returns "" if the profile has no model of the chip.
[[nodiscard]] std::string costOfOpcode(fp::ir::Opcode op, const fp::hw::Profile &profile);

/// True if the program that costOfOpcode() compiles is valid.
[[nodiscard]] bool opcodeLoads(fp::ir::Opcode op, const fp::hw::Profile &profile);

} // namespace arbiter::tools::lsp
