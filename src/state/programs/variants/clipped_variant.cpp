#include "state/programs/variants/clipped_variant.h"

#include "fp_compiler/ir/interface.h"
#include "fp_compiler/ir/ir.h"
#include "state/objects/program_object.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

bool writesClipDistances(const CompiledProgram &compiled) {
  return compiled.program && compiled.program->options.clipsByDistances();
}

std::shared_ptr<const CompiledProgram> ClippedVariant::of(const CompiledProgram &whole,
                                                          std::uint8_t planes,
                                                          std::uint32_t alphaDepths) const {
  Key key = {};
  if (writesClipDistances(whole) && m_distances)
    key = {planes, alphaDepths};
  return m_forms.of(key, [&] {
    auto form = std::make_shared<CompiledProgram>(whole);
    form->clipped = nullptr; // it would keep itself alive
    fp::GlslHost host = m_host;
    host.clipDistances = key.planes;
    host.alphaDepths = key.alphaDepths;
    form->glsl = fp::emitGlsl(*whole.program, host, m_numerics);
    if (debugFlag(DebugFlag::Glsl))
      logText(LogLevel::Debug, "state", toHex(form->hash), form->glsl.text);
    return form;
  });
}

} // namespace arbiter::state
