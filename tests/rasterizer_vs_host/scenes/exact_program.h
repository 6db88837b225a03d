#pragma once
#include <string>

#include "exact_operands.h"

namespace software {

inline constexpr GLenum kExactTargets[kExactUnits] = {
    GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_3D, GL_TEXTURE_1D};

/// Returns the text of a fragment program whose every result is the host's to the bit. Its lines
/// end with "; ".
[[nodiscard]] std::string exactProgram(Random &random);
/// Returns a program that passes an input through, or uses it for a lookup.
[[nodiscard]] std::string plainProgram(Random &random);
/// Returns a program that is exact except for its last instruction, whose rounding is
/// implementation-dependent. It begins with "about NAME: ", a row of exact.py.
[[nodiscard]] std::string nearProgram(Random &random);

} // namespace software
