#include "state/lifecycle/context_hooks.h"

#include "state/context/context.h"
#include "state/host_draw/linking/linked_program_cache.h"
#include "state/raster_draw/context_state.h"
#include "state/statistics/statistics.h"

namespace arbiter::state {

namespace {

void dropLinkedPrograms(CoreContext &context, const CompiledProgram &compiled) {
  DrawContext &whole = wholeOf(context);
  whole.hostSide.linkedPrograms->drop(whole, &compiled);
}

void engageRasterizer(CoreContext &context) { engage(wholeOf(context)); }

bool mayUseRasterizer(const CoreContext &context) { return mayBeUsed(wholeOf(context)); }

bool rasterizerDraws(const CoreContext &context) {
  return context.softwarePossible && wholeOf(context).software->history.backOff.engaged();
}

void forgetPipeline(CoreContext &context) {
  if (const auto &software = wholeOf(context).software)
    software->forgetPipeline();
}

void synchronise(CoreContext &context, const char *name) {
  if (const auto &software = wholeOf(context).software)
    software->residency.synchronise(name);
}

} // namespace

constexpr ContextHooks kContextHooks = {
    .dropLinkedPrograms = dropLinkedPrograms,
    .engageRasterizer = engageRasterizer,
    .mayUseRasterizer = mayUseRasterizer,
    .rasterizerDraws = rasterizerDraws,
    .forgetPipeline = forgetPipeline,
    .synchronise = synchronise,
    .noteLoadedProgram = noteLoadedProgram,
    .noteShader = noteFragmentShader,
};

} // namespace arbiter::state
