#pragma once
#include "fp_compiler/ir/ir.h"
#include "fp_compiler/texture_shader/environment.h"
#include "fp_compiler/texture_shader/state.h"

namespace arbiter::fp::texture_shader {

/// All that decides what is computed of a fragment: the stages, and what their results go to. Bytes
/// without holes.
struct Key {
  State shaders;
  bool combines = false; ///< by register combiners; else by texture environments
  combiners::State combiners;
  Environments environments;
  ir::FogMode fog = ir::FogMode::None; ///< FOG's mode where it is enabled
  bool colorSum = false;
  bool fx9 = false; ///< the combiners' numbers are those of Numerics::Fx9
  bool operator==(const Key &) const = default;
};

/// The key with what it does not depend on as it is initially.
[[nodiscard]] Key essential(const Key &key);

/// The stages and what colours their fragments as straight-line IR of language ArbFragment. Its
/// outputs are Color 0 and, with an operation that replaces depths, Depth. Parameters are env
/// parameters (parameter(), combiners::globalConstant() and combiners::stageConstant()). Cannot
/// fail. Requires an essential() key.
[[nodiscard]] ir::Program lower(const Key &key);

} // namespace arbiter::fp::texture_shader
