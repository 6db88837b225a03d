#pragma once
#include <functional>
#include <optional>

#include "fp_compiler/combiners/state.h"
#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::combiners {

/// Returns the combiners as straight-line IR of an ARB fragment program with the one output Color
/// 0. Its options are those of an empty program, because the final combiner does fog and colour
/// sum. The constant colours are env parameters globalConstant() and stageConstant(). Reads of
/// undefined registers give zero. Cannot fail.
[[nodiscard]] ir::Program lower(const State &state, const Surroundings &surroundings);

/// Returns the initial value of a texture register, or nothing for zeros.
using InitialTexture = std::function<std::optional<ir::Source>(int unit)>;
/// Appends the combiners to code that computes the texture registers (NV_texture_shader, 3.8.13).
/// It samples no unit, and uses only the fog of \p surroundings.
void lower(ir::Builder &builder, const State &state, const Surroundings &surroundings,
           const InitialTexture &textures);

} // namespace arbiter::fp::combiners
