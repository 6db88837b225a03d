#pragma once
#include <cstdint>

#include "fp_compiler/ati/shader.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::ati {

struct LowerOptions {
  /// Registers are clamped to [-range, range] on writes; 0 means no limit. The specification allows
  /// 8 (ATFS:798, AFS:552). Profiles set it as Limits::atiRegisterRange.
  std::uint32_t registerRange = 0;
  /// Clamps constants to [0,1] where the code reads them. Both specifications leave values outside
  /// undefined. The API form does not clamp: applications expect what their hosts do.
  bool clampConstants = true;
};

/// Returns the shader as straight-line IR of language AtiFragment, with explicit code for every
/// modifier. Its one output is Color 0. Constants of kind Env and Local become parameters of those
/// kinds, clamped to [0,1] by the code. Samples have the target Tex2D, but the textures enabled at
/// a draw decide (AFS:353). Options are those of an empty program, because fog and colour sum also
/// depend on the draw. Requires: the shader obeys the rules of its language (shader.h). Cannot
/// fail.
[[nodiscard]] ir::Program lower(const Shader &shader, const LowerOptions &options = {});

} // namespace arbiter::fp::ati
