#pragma once
#include <cstdint>

#include "fp_compiler/ati/shader.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::ati {

struct LowerOptions {
  /// Registers hold values of [-range, range], clamped as they are written; 0: of any size. The
  /// specification allows 8 (ATFS:798, AFS:552). Limits::atiRegisterRange of the profile.
  std::uint32_t registerRange = 0;
  /// Constants beyond [0,1], which both specifications leave undefined, are clamped to it where the
  /// code reads them. Not so for the API form: applications give it what its hosts keep.
  bool clampConstants = true;
};

/// The shader as straight-line IR of language AtiFragment, every modifier spelled out. Its one
/// output is Color 0. Constants of kind Env and Local become parameters of those kinds, clamped to
/// [0,1] by the code. Samples carry the target Tex2D: the textures enabled at a draw decide
/// (AFS:353). Options are those of an empty program: fog and colour sum are the draw's too.
/// Requires: the shader keeps the rules of its language (shader.h). Cannot fail.
[[nodiscard]] ir::Program lower(const Shader &shader, const LowerOptions &options = {});

} // namespace arbiter::fp::ati
