#include "state/programs/vertex_shaders/define_shader.h"

#include <memory>
#include <set>
#include <utility>

#include "fp_compiler/back/assembly/assembly.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/vertex_shader/lower.h"
#include "state/core/context_hooks.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_context.h"
#include "state/programs/program_load.h"
#include "state/programs/variants/clipped_variant.h"
#include "state/programs/variants/drop_variants.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/share/share_group.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

using fp::vertex_shader::From;
using fp::vertex_shader::Lowered;
using Recorded = VertexShaderRecorder::Recorded;

/// Counts the registers that the shader's symbols use, by kind of storage.
void countSymbols(const Recorded &recorded, VertexShaderInputs &inputs) {
  for (std::size_t i = 0; i < recorded.symbols.size(); ++i) {
    const VertexSymbol &symbol = *recorded.symbols[i];
    if (!recorded.used[i])
      continue;
    const auto rows = GLuint(symbol.rows());
    if (symbol.storage == GL_LOCAL_EXT)
      inputs.locals += rows;
    else if (symbol.storage == GL_LOCAL_CONSTANT_EXT)
      inputs.localConstants += rows;
    else if (symbol.meaning.from == From::Attribute)
      inputs.variants += rows;
    else
      inputs.invariants += rows;
  }
}

/// True if two variants that the shader reads have the same attribute.
bool sharesAttributes(const Recorded &recorded) {
  std::set<std::uint8_t> taken;
  for (std::size_t i = 0; i < recorded.symbols.size(); ++i) {
    const VertexSymbol &symbol = *recorded.symbols[i];
    if (!recorded.used[i] || !symbol.isOwn(GL_VARIANT_EXT))
      continue;
    for (int column = 0; column < symbol.rows(); ++column)
      if (!taken.insert(symbol.meaning.attributes[std::size_t(column)].index).second)
        return true;
  }
  return false;
}

bool within(const VertexShaderInputs &inputs, const fp::ResourceCounts &limits,
            std::uint32_t envParameters) {
  return inputs.instructions <= limits.instructions && inputs.variants <= limits.attribs &&
         inputs.invariants <= envParameters && inputs.localConstants <= limits.parameters &&
         inputs.invariants + inputs.localConstants <= limits.parameters &&
         inputs.locals <= limits.temporaries;
}

std::shared_ptr<const VertexShaderInputs>
inputsOf(const ProgramContext &context, const Recorded &recorded, const Lowered &lowered) {
  auto inputs = std::make_shared<VertexShaderInputs>();
  countSymbols(recorded, *inputs);
  inputs->instructions = GLuint(lowered.program.code.size());
  for (const fp::vertex_shader::EnvRow &row : lowered.env) {
    const auto &symbol = recorded.symbols[row.symbol];
    inputs->env.push_back({symbol, row.row});
    inputs->follows = inputs->follows || symbol->follows != VertexSymbol::Follows::Nothing;
  }
  const ProgramTarget &row = context.row(Target::VertexShader);
  const bool enforces = compileOptions(row).policy == fp::LimitPolicy::Enforce;
  inputs->fits = !recorded.tooLong && !sharesAttributes(recorded) &&
                 inputs->env.size() <= row.env.size() &&
                 (!enforces || within(*inputs, row.limits.api, row.limits.envParameters));
  inputs->optimized = inputs->fits && within(*inputs, row.limits.native, row.limits.envParameters);
  return inputs;
}

std::shared_ptr<const CompiledProgram> compile(const ProgramContext &context,
                                               const Recorded &recorded) {
  Lowered lowered = fp::vertex_shader::lower(recorded.shader);
  auto compiled = std::make_shared<CompiledProgram>();
  compiled->target = Target::VertexShader;
  compiled->vertexShader = inputsOf(context, recorded, lowered);
  const std::string listing = fp::ir::print(lowered.program);
  compiled->hash = hashBytes(listing);
  compiled->underNativeLimits = compiled->vertexShader->optimized;
  if (debugFlag(DebugFlag::Ir))
    logText(LogLevel::Debug, "state", toHex(compiled->hash), listing);
  if (!compiled->vertexShader->fits)
    return compiled; // no draw uses it
  const fp::GlslHost host = glslHost(context.caps);
  compiled->glsl = fp::emitGlsl(lowered.program, host, context.numerics);
  compiled->text = fp::emitAssembly(lowered.program);
  compiled->program = std::make_shared<const fp::ir::Program>(std::move(lowered.program));
  fp::GlslHost clipping = host;
  clipping.clipPlanes = true;
  compiled->clipped = std::make_shared<const ClippedVariant>(clipping, context.numerics,
                                                             context.caps.clipDistances());
  if (debugFlag(DebugFlag::Glsl))
    logText(LogLevel::Debug, "state", toHex(compiled->hash), compiled->glsl.text);
  return compiled;
}

} // namespace

void defineVertexShader(ProgramContext &context, const Recorded &recorded) {
  const ProgramTarget &row = context.row(Target::VertexShader);
  std::shared_ptr<const CompiledProgram> compiled = compile(context, recorded);
  context.hooks->noteShader(context, *row.bound, compiled.get(),
                            compiled->vertexShader->fits ? "" : "the shader is over the limits");
  const auto old = context.group->compiledOf(*row.bound);
  context.group->setCompiled(*row.bound, std::move(compiled));
  invalidateProgram(context);
  if (old)
    dropVariants(context, *old);
}

} // namespace arbiter::state
