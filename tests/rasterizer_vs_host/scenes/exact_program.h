#pragma once
#include <string>

#include "surface.h"

namespace software {

/// What a random fragment program samples, a unit each.
inline constexpr int kExactUnits = 5;
inline constexpr GLenum kExactTargets[kExactUnits] = {
    GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_3D, GL_TEXTURE_1D};

/// Returns the text of a fragment program of instructions that round alike wherever they round as
/// they should: sums, products, comparisons, and lookups. Its lines end with "; ".
[[nodiscard]] std::string exactProgram(Random &random);
/// Returns one that hands an input through, or looks up at it.
[[nodiscard]] std::string plainProgram(Random &random);

} // namespace software
