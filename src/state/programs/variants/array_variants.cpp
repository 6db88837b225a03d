#include "state/programs/variants/array_variants.h"

#include "fp_compiler/ir/ir.h"
#include "state/objects/program_object.h"
#include "state/programs/variants/attribute_forms.h"
#include "state/programs/variants/clipped_variant.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

ArrayVariants::ArrayVariants(const fp::ir::Program &whole, fp::GlslHost host, fp::Numerics numerics,
                             bool distances)
    : m_host(host), m_numerics(numerics), m_distances(distances),
      m_beyond(readsBeyondConventional(whole)), m_read(registersOf(whole)) {}

std::shared_ptr<const CompiledProgram>
ArrayVariants::of(const CompiledProgram &whole, std::uint32_t arrays, WiderAttributes wider) const {
  if (wider == WiderAttributes::Generic)
    arrays |= m_beyond;
  arrays &= m_read;
  const std::uint32_t either = wider == WiderAttributes::Beside ? m_beyond & ~arrays : 0;
  if (arrays == 0 && either == 0)
    return whole.shared_from_this();
  return m_forms.of(arrays | either << 16, [&] {
    auto form = std::make_shared<CompiledProgram>(whole);
    form->arrays = nullptr; // it would keep itself alive
    form->program = withAttributes(*whole.program, arrays, either);
    form->glsl = fp::emitGlsl(*form->program, m_host, m_numerics);
    fp::GlslHost clipping = m_host;
    clipping.clipPlanes = true;
    form->clipped = std::make_shared<const ClippedVariant>(clipping, m_numerics, m_distances);
    if (debugFlag(DebugFlag::Glsl))
      logText(LogLevel::Debug, "state", toHex(form->hash), form->glsl.text);
    return form;
  });
}

} // namespace arbiter::state
