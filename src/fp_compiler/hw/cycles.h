#pragma once
#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/r300/machine.h"
#include "fp_compiler/hw/slots.h"

/// How long a pixel keeps one pipe of a card busy, from what was published or measured of it. The
/// sources of the numbers are with them, in cycles.cpp, and in docs/write/native_model.md.
namespace arbiter::fp::hw {

/// Clock cycles of the R300's nodes, ALU and texture units side by side.
[[nodiscard]] CycleEstimate estimateR300(const r300::Code &code);

/// \param model Nv30 or Nv35
[[nodiscard]] CycleEstimate estimateNv30(const SlotProgram &code, NativeModel model);

/// Clock cycles of the i915's slots, one after the other.
[[nodiscard]] CycleEstimate estimateI915(const SlotProgram &code);

} // namespace arbiter::fp::hw
