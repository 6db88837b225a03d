#include "state/contexts/context_hooks.h"

#include "state/core/context.h"
#include "state/host_draw/linking/linked_program_cache.h"
#include "state/raster_draw/context_state.h"
#include "state/statistics/statistics.h"

namespace arbiter::state {

namespace {

void dropLinkedPrograms(Context &context, const CompiledProgram &compiled) {
  context.hostSide.linkedPrograms->drop(context, &compiled);
}

bool rasterizerDraws(const Context &context) {
  return context.softwarePossible && context.software->history.backOff.engaged();
}

void forgetPipeline(Context &context) {
  if (context.software)
    context.software->forgetPipeline();
}

void synchronise(Context &context, const char *name) {
  if (context.software)
    context.software->residency.synchronise(name);
}

} // namespace

constexpr ContextHooks kContextHooks = {
    .dropLinkedPrograms = dropLinkedPrograms,
    .engageRasterizer = software::engage,
    .mayUseRasterizer = software::mayBeUsed,
    .rasterizerDraws = rasterizerDraws,
    .forgetPipeline = forgetPipeline,
    .synchronise = synchronise,
    .noteLoadedProgram = noteLoadedProgram,
    .noteShader = noteFragmentShader,
};

} // namespace arbiter::state
