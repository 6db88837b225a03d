#pragma once
#include <functional>
#include <optional>

#include "fp_compiler/combiners/state.h"
#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::combiners {

/// The combiners as straight-line IR of an ARB fragment program, whose one output is Color 0 and
/// whose options are those of an empty program: fog and colour sum are the final combiner's. Env
/// parameters globalConstant() and stageConstant() are the constant colours. Registers that are
/// undefined where they are read are zero. Cannot fail.
[[nodiscard]] ir::Program lower(const State &state, const Surroundings &surroundings);

/// What a texture register is initialised with; nothing: zeros.
using InitialTexture = std::function<std::optional<ir::Source>(int unit)>;
/// The same behind code that makes the texture registers (NV_texture_shader, 3.8.13): no unit is
/// sampled, and of the surroundings the fog alone is read.
void lower(ir::Builder &builder, const State &state, const Surroundings &surroundings,
           const InitialTexture &textures);

} // namespace arbiter::fp::combiners
