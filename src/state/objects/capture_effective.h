#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "state/objects/target.h"
#include "state/objects/texture_use.h"

namespace arbiter::state {

/// The effective programs in a context, while there is a capture.
struct CaptureEffective {
  std::array<std::shared_ptr<const CompiledProgram>, kTargetCount> programs;
  std::array<std::vector<TextureUse>, kTargetCount> textures;
  std::size_t path = 0; ///< of their draws that the host draws
  // When they became effective: of the path, and of the rasterizer.
  std::uint64_t hostBefore = 0, rasterizedBefore = 0;
};

} // namespace arbiter::state
