#pragma once
#include "fp_compiler/hw/r300/lower/pack.h"

namespace arbiter::fp::hw::r300 {

/// Where everything stands: nodes, their texture accesses, and pairs of operations.
struct Plan {
  struct Slot {
    ItemId rgb = kNoItem, alpha = kNoItem; ///< the same one if it takes both halves
    Packed packed;
  };
  std::vector<Node> nodes;
  std::vector<ItemId> textures;
  std::vector<Slot> slots;
};

/// Fewest nodes first, then fewest pairs: texture accesses stand in the first node that their
/// coordinates allow; operations go by the node that needs them and by the longest way to go.
/// Scalars that either unit can compute go where there is room, so that \p flow changes.
/// Requires: prune().
[[nodiscard]] Plan schedule(Flow &flow);

} // namespace arbiter::fp::hw::r300
