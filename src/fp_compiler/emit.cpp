#include "fp_compiler/back/glsl/glsl.h"
#include "fp_compiler/compiler.h"

namespace arbiter::fp {

GlslShader emitGlsl(const ir::Program &program, const GlslHost &host) {
  ir::Program optimised = program;
  optimise(optimised);
  return glsl::emit(optimised, host);
}

} // namespace arbiter::fp
