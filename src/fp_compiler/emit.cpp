#include "fp_compiler/back/glsl/glsl.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/opt/opt.h"

namespace arbiter::fp {

Numerics numericsOn(const GlslHost &host, Numerics asked) {
  return asked == Numerics::Fp24 && !host.bitEncoding ? Numerics::Legacy : asked;
}

GlslShader emitGlsl(const ir::Program &program, const GlslHost &host, Numerics numerics) {
  const Numerics followed = ir::numericsOf(program.language, numericsOn(host, numerics));
  ir::Program optimised = program;
  opt::lowerOptions(optimised, {.hasNegativeFogDistances = host.negativeFogDistances});
  optimise(optimised, followed);
  return glsl::emit(optimised, host, followed);
}

} // namespace arbiter::fp
