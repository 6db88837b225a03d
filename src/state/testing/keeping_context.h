#pragma once
#include <memory>

#include "state/raster_draw/context_state.h"
#include "state/testing/current_context.h"

namespace arbiter::state::testing {

inline constexpr char kKeepingText[] = "!!ARBfp1.0\nMOV result.color, program.env[0];\nEND";

/// A context with the rasterizer, which keeps primitives from the host.
struct KeepingContext : CurrentContext {
  explicit KeepingContext(FakeHost &host) : CurrentContext(host) {
    Context &context = **this;
    use(context, kKeepingText);
    context.software = std::make_unique<ContextState>(context);
    context.softwarePossible = context.softwareListens = true;
    context.host->GetError();
    host.calls.clear();
  }
  /// Removes the rasterizer, so that the host draws.
  void leaveToHost(FakeHost &host) {
    Context &context = **this;
    context.software = nullptr;
    context.softwarePossible = context.softwareListens = false;
    host.calls.clear();
  }
};

/// Draws a point by Begin and End, with a color of its own if it is `colored`.
inline void point(Context &context, bool colored = false) {
  handlers::Begin(context, GL_POINTS);
  if (context.recorder && colored)
    context.recorder->set(kColor, 1, 0, 0, 1);
  if (context.recorder)
    context.recorder->vertex(1, 2, 0, 1);
  handlers::End(context);
}

} // namespace arbiter::state::testing
