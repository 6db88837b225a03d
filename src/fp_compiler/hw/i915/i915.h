#pragma once
#include "fp_compiler/hw/slots.h"

/// Model of Intel's 915G. Source: Mesa's first i915 driver (i915_fragprog.c, i915_program.c), which
/// translates ARB programs instruction by instruction.
namespace arbiter::fp::hw::i915 {

/// Translates as that driver does: in order, and without dropping dead code.
[[nodiscard]] SlotProgram translate(const ir::Program &program);

/// Returns why an opcode takes more than one slot: "SIN is a polynomial"; nullptr if it takes one.
[[nodiscard]] const char *expansionOf(ir::Opcode op);

inline constexpr std::uint32_t kTextureCoordinates = 8; ///< fragment.position takes one of them

} // namespace arbiter::fp::hw::i915
