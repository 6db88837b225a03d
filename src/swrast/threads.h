#pragma once
#include <cstdint>

/// The rasterizer's threads. There are as many as processors (or ARBITER_THREADS), including the
/// caller's.
namespace arbiter::swrast {

/// Memory work of fewer bytes than this is not worth waking a thread.
inline constexpr std::int64_t kParallelBytes = 512 << 10;

/// Calls `work(argument, i)` for every i below `count`, in any order, on this thread and the
/// workers. Returns when all calls have returned. The process runs one job at a time: a second
/// caller works alone. The workers are started at the first use, with all signals blocked. The
/// child of a fork starts its own.
void parallel(std::uint32_t count, void (*work)(void *argument, std::uint32_t i), void *argument);

template <typename Work> void parallel(std::uint32_t count, Work &work) {
  parallel(
      count, [](void *argument, std::uint32_t i) { (*static_cast<Work *>(argument))(i); }, &work);
}

/// A job that the workers do while the caller goes on; `number` is 0 if there is none.
struct PostedJob {
  std::uint32_t number = 0;
  void *pool = nullptr; ///< the pool it was posted to; a forked child has another one
};
/// Posts a job: the workers begin to call `work(argument, i)` for every i below `count`. Posts none
/// if there are no workers or they are busy; the caller must then do the work.
[[nodiscard]] PostedJob post(std::uint32_t count, void (*work)(void *argument, std::uint32_t i),
                             void *argument);
[[nodiscard]] bool isOver(const PostedJob &job);
/// Works on what is left of the job, and returns when it is done. If a jump leaves this call, it
/// first waits for the workers, at most a second. In a forked child, an index that a worker had
/// taken stays half done, so forks wait for posted jobs first.
void join(const PostedJob &job);
/// Waits until no posted job of any caller is running, at most a second.
void awaitPosted();

/// Returns the number of threads that take part in a job, including the caller's.
[[nodiscard]] int threadCount();
/// Sets the number of threads, for tests and benchmarks; 0 restores the default.
void setThreadCount(int count);

} // namespace arbiter::swrast
