#pragma once
#include "fp_compiler/hw/r300/lower/pack.h"

namespace arbiter::fp::hw::r300 {

/// A schedule: nodes, their texture accesses, and pairs of operations.
struct Plan {
  struct Slot {
    ItemId rgb = kNoItem, alpha = kNoItem; ///< the same item if it takes both halves
    Packed packed;
  };
  std::vector<Node> nodes;
  std::vector<ItemId> textures;
  std::vector<Slot> slots;
};

/// Schedules for the fewest nodes, then for the fewest pairs. A texture access goes in the first
/// node that its coordinates allow. Operations are ordered by the node that needs them, then by
/// their longest path. A scalar that either unit can compute goes where there is room, which
/// changes \p flow.
/// Requires: prune().
[[nodiscard]] Plan schedule(Flow &flow);

} // namespace arbiter::fp::hw::r300
