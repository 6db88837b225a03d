#pragma once
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::analysis {

/// How a register component depends on the attributes. The derivatives in the window of an affine
/// function of the attributes are constant over a plane.
enum class Dependence : std::uint8_t { Uniform, Affine, Other };

/// Returns a flag for each instruction. A flag is true if the instruction samples a texture and its
/// level of detail depends on a coordinate that is not affine in the attributes. Cube maps and
/// programs with loops always count as such.
[[nodiscard]] std::vector<bool> samplesCurved(const ir::Program &program);

} // namespace arbiter::fp::analysis
