#include "state/handlers/entry/offered.h"

#include "state/core/errors.h"
#include "state/era/era_state.h"
#include "state/programs/combiners/combiner_state.h"
#include "state/programs/texture_shaders/texture_shader_state.h"

namespace arbiter::state::offered {

bool stageConstants(const ProgramContext &context) {
  return context.combiners && context.combiners->hasPerStageConstants();
}

bool nvFences(const ProgramContext &context) { return context.era && context.era->offered.nvFence; }
bool appleFences(const ProgramContext &context) {
  return context.era && context.era->offered.appleFence;
}
bool bumpMaps(const ProgramContext &context) { return hasBumpMaps(context); }

bool refuses(ProgramContext &context, const char *why) {
  if (!context.offered)
    return false;
  raise(context, GL_INVALID_OPERATION, why);
  return true;
}

} // namespace arbiter::state::offered
