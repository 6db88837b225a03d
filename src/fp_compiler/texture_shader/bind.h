#pragma once
#include <array>
#include <optional>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/texture_shader/state.h"

namespace arbiter::fp::texture_shader {

/// Values of constant colours, matrices, scales and eye vectors, indexed by their env parameter
/// (combiners::globalConstant(), combiners::stageConstant(), parameter()).
using Values = std::array<std::optional<ir::Vec4>, kParameters>;

/// Replaces env parameters that have a value by constants.
void bindValues(ir::Program &program, const Values &values);

} // namespace arbiter::fp::texture_shader
