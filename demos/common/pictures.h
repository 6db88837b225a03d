#pragma once
#include "common/image.h"

namespace demos {

/// Makes an artificial landscape with the features of a photograph: a smooth sky, a disc, clouds,
/// ridges, lettering and a checker that runs to the horizon. It is the same at every call.
[[nodiscard]] Image makeLandscape(int width, int height);

/// Returns fractal noise of unit amplitude at \p at, from a hash of the lattice; \p octaves layers.
[[nodiscard]] float fractalNoise(glm::vec2 at, int octaves);

} // namespace demos
