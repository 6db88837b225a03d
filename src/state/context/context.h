#pragma once
#include <memory>

#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

/// From the context's creation to its end (lifecycle/lifecycle.h).
struct Life {
  bool initialised = false; ///< the host has been asked for its limits
  bool destroyed = false;   ///< to be freed when it is last made un-current
  int currentCount = 0;     ///< guarded by the lifecycle's lock
};

/// The layer's state of one GL context, for entry points and for what makes contexts. Only the
/// thread that the context is current on uses it. State that other threads may touch is in the
/// ShareGroup.
class Context : public RasterContext {
public:
  struct NullTag {};
  /// Makes the null context, which passes every call through.
  constexpr explicit Context(NullTag);
  Context(Provider contextProvider, const host::HostTable *table,
          std::shared_ptr<ShareGroup> shareGroup);
  ~Context();
  Context(const Context &) = delete;
  Context &operator=(const Context &) = delete;

  Life life;
};

/// Returns the whole context that a step belongs to.
[[nodiscard]] inline Context &wholeOf(ContextHot &context) {
  return static_cast<Context &>(context);
}
[[nodiscard]] inline const Context &wholeOf(const ContextHot &context) {
  return static_cast<const Context &>(context);
}

} // namespace arbiter::state
