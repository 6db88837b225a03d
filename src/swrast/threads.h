#pragma once
#include <cstdint>

/// The rasterizer's threads: as many as processors (ARBITER_THREADS), the caller's included.
namespace arbiter::swrast {

/// Of work on memory: below this, waking a thread costs more than it does.
inline constexpr std::int64_t kParallelBytes = 512 << 10;

/// Calls `work(argument, i)` for every i below `count`, on this thread and the others, in any
/// order; returns when all are done. One job at a time in the process: a second caller works alone.
/// Threads are started at the first call that wants them, with all signals blocked, and are found
/// again after a fork by starting anew.
void parallel(std::uint32_t count, void (*work)(void *argument, std::uint32_t i), void *argument);

template <typename Work> void parallel(std::uint32_t count, Work &work) {
  parallel(
      count, [](void *argument, std::uint32_t i) { (*static_cast<Work *>(argument))(i); }, &work);
}

/// Threads that work, the caller's included.
[[nodiscard]] int threadCount();
/// For measurements and tests; 0 gives the default back.
void setThreadCount(int count);

} // namespace arbiter::swrast
