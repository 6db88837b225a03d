#pragma once
#include <string>

#include "exact_operands.h"

namespace software {

inline constexpr GLenum kExactTargets[kExactUnits] = {
    GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_3D, GL_TEXTURE_1D};

/// Returns the text of a fragment program of which every result is the host's to the bit. Its lines
/// end with "; ".
[[nodiscard]] std::string exactProgram(Random &random);
/// Returns one that hands an input through, or looks up at it.
[[nodiscard]] std::string plainProgram(Random &random);
/// Returns one that is exact but for its last instruction, which the host rounds in its own way:
/// begins with "about NAME: ", a row of run_exact.py.
[[nodiscard]] std::string nearProgram(Random &random);

} // namespace software
