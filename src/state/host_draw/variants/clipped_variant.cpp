#include "state/host_draw/variants/clipped_variant.h"

#include "fp_compiler/ir/interface.h"
#include "fp_compiler/ir/ir.h"
#include "state/programs/program_object.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

bool writesClipDistances(const CompiledProgram &compiled) {
  return compiled.program && compiled.program->options.clipsByDistances();
}

std::shared_ptr<const CompiledProgram> ClippedVariant::of(const CompiledProgram &whole,
                                                          std::uint8_t planes) const {
  const std::uint8_t key = writesClipDistances(whole) && m_distances ? planes : std::uint8_t(0);
  const std::lock_guard lock(m_mutex);
  std::shared_ptr<const CompiledProgram> &known = m_forms[key];
  if (known)
    return known;
  auto form = std::make_shared<CompiledProgram>(whole);
  form->clipped = nullptr; // it would keep itself
  fp::GlslHost host = m_host;
  host.clipDistances = key;
  form->glsl = fp::emitGlsl(*whole.program, host, m_numerics);
  if (debugFlag(DebugFlag::Glsl))
    logText(LogLevel::Debug, "state", toHex(form->hash), form->glsl.text);
  return known = std::move(form);
}

std::vector<std::shared_ptr<const CompiledProgram>> ClippedVariant::made() const {
  const std::lock_guard lock(m_mutex);
  std::vector<std::shared_ptr<const CompiledProgram>> forms;
  for (const auto &each : m_forms)
    forms.push_back(each.second);
  return forms;
}

} // namespace arbiter::state
