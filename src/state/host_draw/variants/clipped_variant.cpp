#include "state/host_draw/variants/clipped_variant.h"

#include "state/programs/program_object.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

std::shared_ptr<const CompiledProgram> ClippedVariant::of(const CompiledProgram &whole) const {
  const std::lock_guard lock(m_mutex);
  if (m_form)
    return m_form;
  auto form = std::make_shared<CompiledProgram>(whole);
  form->clipped = nullptr; // it would keep itself
  form->glsl = fp::emitGlsl(*whole.program, m_host, m_numerics);
  if (debugFlag(DebugFlag::Glsl))
    logText(LogLevel::Debug, "state", toHex(form->hash), form->glsl.text);
  return m_form = std::move(form);
}

std::shared_ptr<const CompiledProgram> ClippedVariant::made() const {
  const std::lock_guard lock(m_mutex);
  return m_form;
}

} // namespace arbiter::state
