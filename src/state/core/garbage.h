#pragma once

namespace arbiter::state {

struct CoreContext;

/// Deletes host objects that the group's destroyed contexts left behind. The context is current.
void collectGarbage(CoreContext &context);

} // namespace arbiter::state
