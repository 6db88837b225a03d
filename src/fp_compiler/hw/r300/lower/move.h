#pragma once
#include "fp_compiler/hw/r300/lower/flow.h"

/// A scalar that is computed component by component may be computed by either unit, if all who read
/// it read nothing but it: the RGB one in x, the alpha one in w.
namespace arbiter::fp::hw::r300 {

/// The same operation of the other unit; None where it has none.
[[nodiscard]] AlphaOp otherUnit(RgbOp op);
[[nodiscard]] RgbOp otherUnit(AlphaOp op);

/// For each item whether it may change the unit. Requires: prune().
[[nodiscard]] std::vector<std::uint8_t> movableItems(const Flow &flow);

/// \p item as the other unit does it.
[[nodiscard]] Item moved(const Item &item);

/// Makes \p reader, an operation, find what \p item was in the component that it is in now.
void readMoved(Item &reader, ItemId item, std::uint8_t component);

} // namespace arbiter::fp::hw::r300
