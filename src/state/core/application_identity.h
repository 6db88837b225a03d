#pragma once

namespace arbiter::state {

struct CoreContext;
struct Identity;

/// Returns the extensions that the application sees; computed at the first call.
[[nodiscard]] const Identity &applicationIdentity(CoreContext &context);

} // namespace arbiter::state
