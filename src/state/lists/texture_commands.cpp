#include "state/lists/texture_commands.h"

#include "state/lists/list_compiler.h"
#include "state/programs/combiners/combiner_state.h"
#include "state/programs/texture_changes.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/raster_draw/raster_context.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// True if a list may be called while texture shaders or register combiners are enabled.
bool listsFollowTextures(const RasterContext &context) {
  if (context.textureShaders && context.textureShaders->used)
    return true;
  return mayCombineDepths(context) &&
         context.group->shadersFollowFixedFunction.load(std::memory_order_relaxed);
}

} // namespace

void noteTextureCommand(RasterContext &context) {
  noteTextureChange(context);
  if (context.listMode != 0 && !context.insideBeginEnd && listsFollowTextures(context))
    listCompiler(context).cut(context);
}

} // namespace arbiter::state
