#pragma once
#include <mutex>

#include <unistd.h>

namespace arbiter {

/// The lock of a mutex, for what is done when the process ends: waits a tenth of a second at most,
/// as a frame below may hold it, where a signal's handler called exit(). Test it before relying on
/// what it guards.
[[nodiscard]] inline std::unique_lock<std::mutex> lockAtExit(std::mutex &mutex) {
  std::unique_lock lock(mutex, std::try_to_lock);
  for (int i = 0; i < 100 && !lock.owns_lock(); ++i) {
    ::usleep(1000);
    static_cast<void>(lock.try_lock());
  }
  return lock;
}

} // namespace arbiter
