#pragma once
#include "fp_compiler/compiler.h"

namespace arbiter::fp::glsl {

/// Translates a validated program to a GLSL shader of its stage, instruction by instruction.
/// ir/semantics.h defines the meaning. Does not optimise.
/// Requires: opt::lowerOptions() has run.
[[nodiscard]] GlslShader emit(const ir::Program &program, const GlslHost &host,
                              Numerics numerics = Numerics::Host);

} // namespace arbiter::fp::glsl
