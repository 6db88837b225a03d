#pragma once
#include "common/image.h"

namespace demos {

/// A made-up landscape with what a photograph has: a smooth sky, a disc, clouds, ridges, lettering
/// and a checker that runs to the horizon. The same at every call.
[[nodiscard]] Image makeLandscape(int width, int height);

/// Fractal noise of unit amplitude at \p at, from a hash of the lattice; \p octaves layers.
[[nodiscard]] float fractalNoise(glm::vec2 at, int octaves);

} // namespace demos
