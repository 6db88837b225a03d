#include "state/programs/variants/ati_variants.h"

#include "fp_compiler/back/assembly/assembly.h"
#include "state/objects/program_object.h"
#include "state/programs/variants/depth_variants.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

/// Returns the part of the state that the shader sees, so that what it does not sample makes no
/// further variant.
fp::FixedFunction seenBy(std::uint32_t units, const fp::FixedFunction &state) {
  fp::FixedFunction seen = state;
  for (std::size_t unit = 0; unit < seen.targets.size(); ++unit)
    if ((units >> unit & 1u) == 0)
      seen.targets[unit] = {};
  seen.disabledUnits &= std::uint8_t(units);
  return seen;
}

} // namespace

AtiVariants::AtiVariants(fp::ir::Program program, fp::GlslHost host, fp::Numerics numerics)
    : m_program(std::move(program)), m_host(host), m_numerics(numerics) {
  for (const fp::ir::Instruction &instruction : m_program.code)
    if (fp::ir::info(instruction.op).has(fp::ir::Texture))
      m_units |= 1u << instruction.unit;
}

std::shared_ptr<const CompiledProgram> AtiVariants::under(const CompiledProgram &whole,
                                                          const fp::FixedFunction &state) const {
  const fp::FixedFunction seen = seenBy(m_units, state);
  return m_forms.of(seen, [&] {
    auto form = std::make_shared<CompiledProgram>();
    form->target = whole.target;
    form->hash = whole.hash;
    form->commands = whole.commands;
    fp::ir::Program program = fp::withFixedFunction(m_program, seen);
    form->glsl = fp::emitGlsl(program, m_host, m_numerics);
    form->program = std::make_shared<const fp::ir::Program>(program);
    form->depths = std::make_shared<const DepthVariants>(m_host, m_numerics);
    form->text = fp::emitAssembly(fp::asArbFragment(std::move(program)));
    if (whole.replaced())
      form->replacement = form->text; // it was emitted from the replacement
    if (debugFlag(DebugFlag::Glsl))
      logText(LogLevel::Debug, "state", toHex(form->hash), form->glsl.text);
    return form;
  });
}

} // namespace arbiter::state
