#pragma once
#include "fp_compiler/hw/r300/pair/schedule.h"

namespace arbiter::fp::hw::r300 {

/// Returns the register of each web, by its root; kNone for webs without live items. Uses a linear
/// scan for each component, so a value of the alpha unit may share a register with one of the RGB
/// unit.
[[nodiscard]] std::vector<std::uint16_t> allocate(const Flow &flow, const Plan &plan);

} // namespace arbiter::fp::hw::r300
