#pragma once
#include <cstddef>

namespace arbiter {

/// Starts a thread of the layer in an application's process. It takes no signals (the application's
/// handlers run on the application's threads). Its stack has `stackBytes`, whatever limits the
/// process has. Its floating-point environment is the default (to nearest, no traps). It is never
/// joined and ends with the process.
/// \param name at most 15 characters
/// \returns false if there are no more threads or no memory.
[[nodiscard]] bool startThread(const char *name, std::size_t stackBytes, void (*run)(void *),
                               void *argument) noexcept;

/// Prevents cancellation of the calling thread (pthread_cancel) while it lives. Within a GL command
/// the layer may wait or open files, which are cancellation points, and must not stop halfway. The
/// application's next cancellation point acts on the request.
class NoCancel {
public:
  NoCancel() noexcept;
  ~NoCancel();
  NoCancel(const NoCancel &) = delete;
  NoCancel &operator=(const NoCancel &) = delete;

private:
  int m_before = 0;
};

} // namespace arbiter
