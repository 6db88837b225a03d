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

/// A job that the other threads are at while the caller goes on; none where `number` is 0.
struct PostedJob {
  std::uint32_t number = 0;
  void *pool = nullptr; ///< a process that was forked has another one
};
/// Has the other threads begin to call `work(argument, i)` for every i below `count`. None is
/// posted where there are no others, or where they are at another job: the caller does it then.
[[nodiscard]] PostedJob post(std::uint32_t count, void (*work)(void *argument, std::uint32_t i),
                             void *argument);
[[nodiscard]] bool isOver(const PostedJob &job);
/// Works on what is left of the job, and returns when all is done. A jump over it waits until the
/// other threads have done that, or for a second. In a child of the process that posted it, what
/// another thread was at stays half done (before a fork that is waited for).
void join(const PostedJob &job);
/// Waits until no posted job is under way, of any caller, or for a second.
void awaitPosted();

/// Threads that work, the caller's included.
[[nodiscard]] int threadCount();
/// For measurements and tests; 0 gives the default back.
void setThreadCount(int count);

} // namespace arbiter::swrast
