#pragma once
#include <chrono>
#include <functional>
#include <sys/types.h>

/// Processes that are forked from this one.
namespace arbiter::tools {

/// Starts a process that does the work and exits with its result. The kernel kills it if this one
/// ends before. \returns the process, or -1 with errno set
[[nodiscard]] pid_t startChild(const std::function<int()> &work);

/// Waits until the process ends, or the time is over. \param status set as by waitpid()
/// \returns true if it has ended, or is no child of this process
[[nodiscard]] bool awaitChild(pid_t child, std::chrono::milliseconds atMost, int &status);

/// Sends the process a signal, 0: none, and waits for its end.
void endChild(pid_t child, int signal);

} // namespace arbiter::tools
