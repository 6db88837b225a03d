#pragma once
#include <functional>
#include <string>
#include <vector>

#include "apps/tools/launch/launch.h"

namespace arbiter::tools {

/// Runs the command as a child, waits for its end, and then calls `afterwards`. Signals sent to
/// this process alone are passed on; signals from a terminal reach the child directly. When the
/// child stops, this process stops too, until both continue. If this process is killed, the child
/// is killed as well; a helper process then calls `afterwards`.
/// \param afterwards called when the child is dead, before this returns
/// \returns waitpid()'s status, or -1 after a complaint if no child could be started
[[nodiscard]] int supervise(const std::vector<Assignment> &environment,
                            const std::vector<std::string> &command,
                            const std::function<void()> &afterwards);

/// Ends this process as a child with that status ended: with its exit code, or by the same signal.
/// A shell then sees the child's result. No second core is dumped.
[[noreturn]] void endAs(int status);

} // namespace arbiter::tools
