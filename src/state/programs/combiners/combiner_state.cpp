#include "state/programs/combiners/combiner_state.h"

#include <algorithm>

#include "fp_compiler/combiners/lower.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_context.h"
#include "state/programs/state_text.h"
#include "state/share/share_group.h"

namespace arbiter::state {

CombinerSettings &CombinerState::writable() {
  if (m_settings.use_count() > 1)
    m_settings = std::make_shared<CombinerSettings>(*m_settings);
  return *m_settings;
}

void CombinerState::changed(ProgramContext &context) {
  if (context.row(Target::Combiners).enabled)
    invalidateProgram(context);
}

void CombinerState::setConstant(ProgramContext &context, int index, const Vec4 &value) {
  if (constant(index) == value)
    return;
  writable().constants[std::size_t(index)] = value;
  for (const Target target : {Target::Combiners, Target::TextureShaders})
    if (ProgramTarget &row = context.row(target); row.offered) {
      row.env[std::size_t(index)] = value;
      ++row.envVersion;
      context.attention |= row.parameterBits;
    }
}

void CombinerState::restore(ProgramContext &context,
                            const std::shared_ptr<const CombinerSettings> &settings) {
  if (settings == m_settings)
    return;
  // valid, because this class made them
  m_settings = std::const_pointer_cast<CombinerSettings>(settings);
  for (const Target target : {Target::Combiners, Target::TextureShaders})
    if (ProgramTarget &row = context.row(target); row.offered) {
      std::copy(m_settings->constants.begin(), m_settings->constants.end(), row.env.begin());
      ++row.envVersion;
      context.attention |= row.parameterBits;
    }
  changed(context);
}

std::shared_ptr<const CompiledProgram> CombinerState::programUnder(ProgramContext &context,
                                                                   const Key &key,
                                                                   const fp::GlslHost &host,
                                                                   const StateText *text) {
  StatePrograms<Key> &programs = text ? m_named.of(context, text->key()) : m_programs;
  return programs.of(context, Target::Combiners, key, host, text, [&](const Key &of) {
    fp::ir::Program program = fp::combiners::lower(of.state, of.around);
    if (text && text->replaced)
      fp::texture_shader::bindValues(program, text->replaced->values);
    return program;
  });
}

bool combinerValue(const ProgramContext &context, GLenum pname, GLint &value) {
  const CombinerState *const combiners = context.combiners.get();
  if (!combiners)
    return false;
  switch (pname) {
  case infoOf(Target::Combiners).name:
    value = context.row(Target::Combiners).enabled ? 1 : 0;
    return true;
  case GL_NUM_GENERAL_COMBINERS_NV:
    value = combiners->state().count;
    return true;
  case GL_COLOR_SUM_CLAMP_NV:
    value = combiners->state().sumClamp ? 1 : 0;
    return true;
  case GL_MAX_GENERAL_COMBINERS_NV:
    value = combiners->stages();
    return true;
  default:
    value = combiners->state().perStageConstants ? 1 : 0;
    return combiners->hasPerStageConstants();
  }
}

bool mayCombineDepths(const ProgramContext &context) {
  return context.combiners && context.caps.shadow &&
         context.group->depthImagesUsed.load(std::memory_order_relaxed);
}

bool followsDepths(const ProgramContext &context) {
  return mayCombineDepths(context) && context.combiners->effective;
}

} // namespace arbiter::state
