#include "state/programs/variants/state_program.h"

#include <string>

#include "fp_compiler/back/assembly/assembly.h"
#include "fp_compiler/ir/print.h"
#include "state/programs/program_context.h"
#include "state/programs/state_text.h"
#include "state/programs/variants/depth_variants.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

std::shared_ptr<const CompiledProgram> programOfState(const ProgramContext &context, Target target,
                                                      fp::ir::Program program,
                                                      const fp::GlslHost &host,
                                                      const StateText *text) {
  auto compiled = std::make_shared<CompiledProgram>();
  compiled->target = target;
  const std::string listing = fp::ir::print(program);
  compiled->hash = text ? text->hash : hashBytes(listing);
  compiled->underNativeLimits = true;
  compiled->glsl = fp::emitGlsl(program, host, context.numerics);
  compiled->depths = std::make_shared<const DepthVariants>(host, context.numerics);
  compiled->text = fp::emitAssembly(program);
  if (text && text->replaced)
    compiled->replacement = compiled->text;
  compiled->program = std::make_shared<const fp::ir::Program>(std::move(program));
  if (debugFlag(DebugFlag::Ir))
    logText(LogLevel::Debug, "state", toHex(compiled->hash), listing);
  if (debugFlag(DebugFlag::Glsl))
    logText(LogLevel::Debug, "state", toHex(compiled->hash), compiled->glsl.text);
  if (text)
    context.stateTexts->noteProgram(context, *text, *compiled);
  return compiled;
}

} // namespace arbiter::state
