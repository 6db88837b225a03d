#pragma once
#include <cstddef>

namespace arbiter {

/// Starts a thread of the layer's in an application's process: it takes no signal (the
/// application's handlers run on the application's threads), its stack has `stackBytes` whatever
/// limits the process was given, its floating-point environment is the default one (to nearest, no
/// traps), and it is never joined: it ends with the process. \param name at most 15 characters
/// \returns false if there are no more threads or no memory.
[[nodiscard]] bool startThread(const char *name, std::size_t stackBytes, void (*run)(void *),
                               void *argument) noexcept;

/// While it lives, the calling thread is not cancelled (pthread_cancel): what the layer does within
/// a GL command may wait or open files, which are points of cancellation, and must not be left half
/// done. The request is met at the application's next one.
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
