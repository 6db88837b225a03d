#pragma once

namespace arbiter::state {

class Context;

/// Deletes host objects that the group's destroyed contexts left behind. The context is current.
void collectGarbage(Context &context);

} // namespace arbiter::state
