#pragma once
#include "fp_compiler/ir/ir.h"
#include "fp_compiler/texture_shader/environment.h"
#include "fp_compiler/texture_shader/state.h"

namespace arbiter::fp::texture_shader {

/// All state that decides how a fragment's colour is computed: the stages, and the combiners or
/// environments after them. It has no padding.
struct Key {
  State shaders;
  bool combines = false; ///< true: register combiners; false: texture environments
  combiners::State combiners;
  Environments environments;
  ir::FogMode fog = ir::FogMode::None; ///< FOG_MODE, or None if fog is disabled
  bool colorSum = false;
  bool fx9 = false; ///< combiners use the numbers of Numerics::Fx9
  bool operator==(const Key &) const = default;
};

/// Returns the key with irrelevant parts reset to their initial values.
[[nodiscard]] Key essential(const Key &key);

/// Returns the stages and the colour computation as straight-line IR of language ArbFragment. Its
/// outputs are Color 0 and, if an operation replaces depths, Depth. It has only env parameters:
/// parameter(), combiners::globalConstant() and combiners::stageConstant(). Cannot fail. Requires:
/// \p key is essential().
[[nodiscard]] ir::Program lower(const Key &key);

} // namespace arbiter::fp::texture_shader
