#pragma once

/// Tells whether the process is ending by exit(). The host's exit handlers free what it has, and
/// run before handlers that the application registered earlier. If such a handler releases a
/// context, the host must not draw or copy any more.
namespace arbiter::state {

/// Makes exitBegan() true in exit handlers that were registered before this call. Only the first
/// call has an effect.
void watchExit();
[[nodiscard]] bool exitBegan();

} // namespace arbiter::state
