#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "state/core/target.h"
#include "state/report/capture_record.h"

namespace arbiter::state {

/// The programs in force in a context, while there is a capture.
struct CaptureInForce {
  std::array<std::shared_ptr<const CompiledProgram>, kTargetCount> programs;
  std::array<std::vector<TextureUse>, kTargetCount> textures;
  std::uint64_t drawsBefore = 0; ///< of the path, when they came into force
  std::size_t path = 0;
};

} // namespace arbiter::state
