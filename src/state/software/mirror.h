#pragma once
#include <array>
#include <cstdint>

#include <GL/gl.h>

#include "fp_compiler/abi.h"
#include "state/software/attributes.h"
#include "swrast/rasterize.h"

/// The host's state as far as a draw of ours depends on it. The host is always right about state,
/// and is asked for a group only after a command that may have changed it (stale.h).
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

struct SamplerState {
  GLuint texture = 0;  ///< bound to the target that the program samples
  abi::SamplerKey key; ///< without format, completeness and size
  float lodBias = 0, minLod = -1000, maxLod = 1000;
  GLint baseLevel = 0, maxLevel = 1000;
  float borderColor[4] = {};
  bool known = true; ///< false: a mode that we lack
};

struct Mirror {
  swrast::RasterState raster; ///< without clip, which depends on the target
  swrast::Rect scissor;       ///< the target's size where the test is disabled
  bool scissorEnabled = false;
  abi::FragmentKey pixelOps;   ///< tests, blending, masks; without formats, inputs and samplers
  abi::FragmentData constants; ///< references, blend colour, fog
  std::array<std::array<SamplerState, 5>, abi::kMaxUnits> samplers; ///< by unit and abi::Dimension
  CurrentValues current{};
  VertexSource arrays;            ///< enabled client and buffer arrays
  const char *obstacle = nullptr; ///< what of the state keeps draws with the host; a reason

  // Fixed-function vertices; see fixed_vertex.h.
  bool twoSidedColor = false;
};

/// Asks the host for the groups that are stale and that a draw needs. Raises no error.
void refresh(Context &context, Mirror &mirror);

} // namespace arbiter::state::software
