#include "state/host_draw/fixed_function.h"

#include "state/host_draw/draw_context.h"
#include "state/host_draw/texturing/fixed_function_now.h"
#include "state/programs/program_bind.h"
#include "state/programs/texture_changes.h"
#include "state/programs/variants/ati_variants.h"
#include "state/share/share_group.h"

namespace arbiter::state {

std::shared_ptr<const CompiledProgram> chooseAtiShaderProgram(DrawContext &context) {
  for (const Target target : {Target::AtiText, Target::AtiApi}) {
    ProgramTarget &row = context.row(target);
    if (!row.enabled)
      continue;
    const auto compiled = context.group->compiledOf(*row.bound);
    if (!compiled)
      continue;
    context.followsFixedFunction = true;
    return compiled->ati->under(*compiled, fixedFunctionNow(context, compiled->ati->units()));
  }
  return nullptr;
}

void noteFixedFunctionChange(DrawContext &context) {
  if (context.followsFixedFunction)
    invalidateProgram(context);
  else
    noteTextureChange(context); // fixed function's own textures may have changed
}

void noteFixedFunctionCommand(DrawContext &context) {
  if (context.insideBeginEnd)
    return; // it was an error
  noteFixedFunctionChange(context);
  if (context.listMode && context.group->shadersFollowFixedFunction.load(std::memory_order_relaxed))
    context.list->cut(context);
}

} // namespace arbiter::state
