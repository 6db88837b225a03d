#pragma once
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::analysis {

/// How a register's component depends on the attributes: not at all, as an affine function of them
/// (so that its derivatives in the window are the same everywhere on a plane), or in another way.
enum class Dependence : std::uint8_t { Uniform, Affine, Other };

/// For each instruction of the program: true where it samples a texture and the level of detail
/// depends on a coordinate that is not affine in the attributes. A cube map's always does, one in a
/// program with loops is taken to.
[[nodiscard]] std::vector<bool> samplesCurved(const ir::Program &program);

} // namespace arbiter::fp::analysis
