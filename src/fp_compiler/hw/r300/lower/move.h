#pragma once
#include "fp_compiler/hw/r300/lower/flow.h"

/// Moves a scalar operation to the other unit: the RGB unit computes it in x, the alpha unit in w.
/// All its readers must read it alone.
namespace arbiter::fp::hw::r300 {

/// Returns the operation of the other unit, or None if that has none.
[[nodiscard]] AlphaOp otherUnit(RgbOp op);
[[nodiscard]] RgbOp otherUnit(AlphaOp op);

/// Returns for each item whether it may move to the other unit.
/// Requires: prune().
[[nodiscard]] std::vector<std::uint8_t> movableItems(const Flow &flow);

/// Returns \p item as an operation of the other unit.
[[nodiscard]] Item moved(const Item &item);

/// Makes \p reader read \p item in its new component.
void readMoved(Item &reader, ItemId item, std::uint8_t component);

} // namespace arbiter::fp::hw::r300
