#include "state/programs/variants/depth_variants.h"

#include "fp_compiler/ir/ir.h"
#include "state/objects/program_object.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

std::shared_ptr<const CompiledProgram> DepthVariants::of(const CompiledProgram &whole,
                                                         std::uint32_t alphaDepths) const {
  if (alphaDepths == 0)
    return whole.shared_from_this();
  return m_forms.of(alphaDepths, [&] {
    auto form = std::make_shared<CompiledProgram>(whole);
    form->depths = nullptr; // it would keep itself alive
    fp::GlslHost host = m_host;
    host.alphaDepths = alphaDepths;
    form->glsl = fp::emitGlsl(*whole.program, host, m_numerics);
    if (debugFlag(DebugFlag::Glsl))
      logText(LogLevel::Debug, "state", toHex(form->hash), form->glsl.text);
    return form;
  });
}

std::shared_ptr<const CompiledProgram> DepthVariants::ofSprites(const CompiledProgram &whole,
                                                                const SpriteForm &sprites) const {
  if (sprites.units == 0)
    return whole.shared_from_this();
  return m_sprites.of(sprites, [&] {
    auto form = std::make_shared<CompiledProgram>(whole);
    fp::GlslHost host = m_host;
    host.spriteUnits = sprites.units;
    host.spriteS = sprites.fromS != 0;
    form->depths = std::make_shared<const DepthVariants>(host, m_numerics);
    form->glsl = fp::emitGlsl(*whole.program, host, m_numerics);
    if (debugFlag(DebugFlag::Glsl))
      logText(LogLevel::Debug, "state", toHex(form->hash), form->glsl.text);
    return form;
  });
}

} // namespace arbiter::state
