#include "state/programs/texture_changes.h"

#include "state/programs/combiners/combiner_state.h"
#include "state/programs/program_context.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

void noteTextureChange(ProgramContext &context) {
  if (!followsTextures(context) && !followsDepths(context))
    return;
  context.texturesChanged = true;
  context.attention |= attention::kDepth;
}

bool texturesMayDiffer(const ProgramContext &context) {
  return context.texturesChanged || context.group->contexts.load(std::memory_order_relaxed) > 1;
}

} // namespace arbiter::state
