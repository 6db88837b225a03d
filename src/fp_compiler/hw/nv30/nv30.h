#pragma once
#include "fp_compiler/hw/slots.h"

/// Model of NVIDIA's NV30 and NV35. Sources: NV_fragment_program, whose instructions are the
/// chip's, and Mesa 22.3.6's nv30 driver for opcodes that the specification lacks.
namespace arbiter::fp::hw::nv30 {

/// Translates instruction by instruction. Dead code is dropped; nothing is reordered or merged.
[[nodiscard]] SlotProgram translate(const ir::Program &program);

/// Returns why an opcode takes more than one slot: "SCS is a SIN and a COS"; nullptr if it takes
/// one.
[[nodiscard]] const char *expansionOf(ir::Opcode op);

/// Returns how many passes through the unit an opcode takes. Sources: cycles.cpp.
[[nodiscard]] std::uint8_t passesOf(ir::Opcode op);

} // namespace arbiter::fp::hw::nv30
