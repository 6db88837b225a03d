#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tools/launch/launch.h"

namespace arbiter::tools {

/// Runs the command as a child and waits for it, for what is to be done when it is dead. Signals
/// that are sent to this process alone are passed on; of those that a terminal sends to the whole
/// group the child has its own. A child that stops stops this process too, until both go on. If
/// this process is killed its child is, as the two are one to who started them, and a helper of its
/// own calls `afterwards` all the same. \param afterwards called when the child is dead, before
/// this returns \returns waitpid()'s status, or -1 where there could be no child (said on standard
/// error).
[[nodiscard]] int supervise(const std::vector<Assignment> &environment,
                            const std::vector<std::string> &command,
                            const std::function<void()> &afterwards);

/// Ends this process as the child of that status ended: by its code, or by the signal itself, so
/// that a shell sees what it would have seen without this process. No core is dumped a second time.
[[noreturn]] void endAs(int status);

} // namespace arbiter::tools
