#pragma once

namespace arbiter::state {

class Context;

/// Deletes host objects that dead contexts of the group left. The context is current.
void collectGarbage(Context &context);

} // namespace arbiter::state
