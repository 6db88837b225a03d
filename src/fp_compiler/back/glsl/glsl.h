#pragma once
#include "fp_compiler/compiler.h"

namespace arbiter::fp::glsl {

/// Writes a validated program as a GLSL shader of its stage, instruction by instruction; the
/// meaning is that of ir/semantics.h. Does not optimise.
[[nodiscard]] GlslShader emit(const ir::Program &program, const GlslHost &host,
                              Numerics numerics = Numerics::Host);

} // namespace arbiter::fp::glsl
