#pragma once
#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/r300/machine.h"
#include "fp_compiler/hw/slots.h"

/// Estimates how many clocks a pixel keeps one pipe of a card busy, from published or measured
/// figures. The sources of the figures are in cycles.cpp and in docs/write/native_model.md.
namespace arbiter::fp::hw {

/// Returns clock cycles for the R300, whose ALU and texture units run in parallel.
[[nodiscard]] CycleEstimate estimateR300(const r300::Code &code);

/// Returns clock cycles for the NV30 or NV35.
/// \param model Nv30 or Nv35
[[nodiscard]] CycleEstimate estimateNv30(const SlotProgram &code, NativeModel model);

/// Returns clock cycles for the i915, which runs one slot after the other.
[[nodiscard]] CycleEstimate estimateI915(const SlotProgram &code);

} // namespace arbiter::fp::hw
