#pragma once
#include <mutex>

#include <unistd.h>

namespace arbiter {

/// Locks a mutex for work at the end of the process. It waits a tenth of a second at most: if a
/// signal handler called exit(), a frame below may hold the mutex. Test the result before relying
/// on what the mutex guards.
[[nodiscard]] inline std::unique_lock<std::mutex> lockAtExit(std::mutex &mutex) {
  std::unique_lock lock(mutex, std::try_to_lock);
  for (int i = 0; i < 100 && !lock.owns_lock(); ++i) {
    ::usleep(1000);
    static_cast<void>(lock.try_lock());
  }
  return lock;
}

} // namespace arbiter
