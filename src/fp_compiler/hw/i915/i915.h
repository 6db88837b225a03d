#pragma once
#include "fp_compiler/hw/slots.h"

/// Intel's 915G. Facts: Mesa's first i915 driver (i915_fragprog.c, i915_program.c), which
/// translates ARB programs instruction by instruction.
namespace arbiter::fp::hw::i915 {

/// As that driver does: in order, dead code and all.
[[nodiscard]] SlotProgram translate(const ir::Program &program);

/// "SIN is a polynomial", or nullptr.
[[nodiscard]] const char *expansionOf(ir::Opcode op);

inline constexpr std::uint32_t kTextureCoordinates = 8; ///< fragment.position takes one

} // namespace arbiter::fp::hw::i915
