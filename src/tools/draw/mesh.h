#pragma once
#include <array>
#include <vector>

#include "tools/draw/scene.h"

namespace arbiter::tools {

struct MeshVertex {
  std::array<float, 3> position; ///< object coordinates; z towards the viewer
  std::array<float, 3> normal;
  float s, t;
};

/// Four vertices a quad, counter-clockwise.
[[nodiscard]] std::vector<MeshVertex> quadsOf(Mesh mesh);

} // namespace arbiter::tools
