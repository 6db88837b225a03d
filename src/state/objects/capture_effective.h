#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "state/objects/target.h"
#include "state/objects/texture_use.h"

namespace arbiter::state {

/// The effective programs of a context, while there is a capture.
struct CaptureEffective {
  std::array<std::shared_ptr<const CompiledProgram>, kTargetCount> programs;
  std::array<std::vector<TextureUse>, kTargetCount> textures;
  std::size_t path = 0; ///< the path of draws that the host does
  // The draw counters of the path and of the rasterizer when the programs became effective.
  std::uint64_t hostBefore = 0, rasterizedBefore = 0;
};

} // namespace arbiter::state
