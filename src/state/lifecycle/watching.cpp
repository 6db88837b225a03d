#include "state/lifecycle/watching.h"

#include <utility>

#include "state/context/context.h"
#include "state/control/session.h"
#include "state/core/control_hooks.h"
#include "state/core/memory.h"
#include "state/hud/hud.h"
#include "state/objects/linked_program.h"
#include "state/programs/program_edits.h"
#include "util/flags.h"

namespace arbiter::state {

namespace {

/// Returns the draws that took the path of the effective program, on the host or by the rasterizer.
std::uint64_t drawsOf(const Context &context, std::size_t path) {
  return context.counters.draws[path] + context.counters.draws[std::size_t(Path::Rasterizer)];
}

void programsLeave(CoreContext &core) {
  Context &context = wholeOf(core);
  if (control::Session *const session = control::Session::instance(); session && session->isBusy())
    session->tallies().end(
        context.serial, [&](std::size_t path) { return drawsOf(context, path); },
        context.counters.draws[std::size_t(Path::Rasterizer)]);
}

void programsEnter(CoreContext &core) {
  Context &context = wholeOf(core);
  control::Session *const session = control::Session::instance();
  if (!session || !session->isBusy() || !context.effective.linkedProgram)
    return;
  control::Tallies::Begun begun;
  const auto stages = context.effective.linkedProgram->stages();
  for (std::size_t i = 0; i < stages.size(); ++i)
    if (const CompiledProgram *const compiled = stages[i]->compiled)
      begun.programs[i] = textFileName(compiled->target, compiled->hash);
  begun.path = std::size_t(context.effective.path);
  begun.drawsBefore = drawsOf(context, begun.path);
  begun.rasterizedBefore = context.counters.draws[std::size_t(Path::Rasterizer)];
  begun.since = control::nowNanoseconds();
  session->tallies().begin(context.serial, std::move(begun));
}

void frameEnds(CoreContext &core) {
  Context &context = wholeOf(core);
  if (control::Session *const session = control::Session::instance()) {
    session->noteActivity(true);
    if (session->isBusy() && context.executesNow()) [[unlikely]] {
      programsLeave(context);
      if (g_observed.load(std::memory_order_relaxed) != nullptr)
        session->endObservation(context);
      session->frameEnded();
      session->serve(context);
      session->lendFrame(context);
      programsEnter(context);
    }
  } else if (controlled()) {
    control::Session::begin(); // in a child of a fork
  }
  if (settings().hud.on && context.executesNow())
    hud::draw(context);
}

/// Serves requests before a draw, unless there are contexts that end frames; those serve them.
void beforeDraw(CoreContext &core) {
  Context &context = wholeOf(core);
  control::Session *const session = control::Session::instance();
  if (!session || !session->isBusy()) [[likely]] // the common case
    return;
  session->noteActivity(false);
  if (session->endsFrames() || !context.executesNow())
    return;
  // No end of a frame takes the tally, and the programs may stay the same for good.
  programsLeave(context);
  session->serve(context);
  programsEnter(context);
}

constexpr ControlHooks kHooks = {frameEnds, beforeDraw, programsLeave, programsEnter};

} // namespace

void beginWatching() {
  if (!controlled() && !settings().hud.on)
    return;
  if (controlled())
    control::Session::begin();
  g_controlHooks.store(&kHooks, std::memory_order_release);
}

} // namespace arbiter::state
