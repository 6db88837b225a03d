#pragma once

/// Whether the process ends by exit(). The host frees what it has in exit handlers of its own,
/// which run before those that the application registered earlier: a context that such a handler
/// takes from its thread must not have the host draw or copy any more.
namespace arbiter::state {

/// From now on exitBegan() is true in exit handlers that were registered before this call. Once a
/// process; later calls do nothing.
void watchExit();
[[nodiscard]] bool exitBegan();

} // namespace arbiter::state
