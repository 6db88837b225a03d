#pragma once
#include "fp_compiler/hw/slots.h"

/// NVIDIA's NV30 and NV35. Facts: NV_fragment_program, whose instructions are the chip's, and Mesa
/// 22.3.6's nv30 driver for what that specification has no instruction for.
namespace arbiter::fp::hw::nv30 {

/// Translates instruction by instruction. Dead code is dropped; nothing is reordered or merged.
[[nodiscard]] SlotProgram translate(const ir::Program &program);

/// "SCS is a SIN and a COS", or nullptr.
[[nodiscard]] const char *expansionOf(ir::Opcode op);

/// Passes through the unit: see cycles.h for the sources.
[[nodiscard]] std::uint8_t passesOf(ir::Opcode op);

} // namespace arbiter::fp::hw::nv30
