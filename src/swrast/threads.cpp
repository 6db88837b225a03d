#include "swrast/threads.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iterator>
#include <new>
#include <pthread.h>
#include <sched.h>
#include <thread>
#include <utility>

#include "swrast/jump_guard.h"
#include "util/flags.h"
#include "util/thread.h"

namespace arbiter::swrast {
namespace {

constexpr int kMaxThreads = 64;
/// The workers' stack size. It is fixed because the default follows the application's stack limit,
/// which says nothing about what the layer needs.
constexpr std::size_t kWorkerStack = std::size_t(1) << 20;
/// How long a worker spins for the next job, and a caller for the last worker, before it sleeps. It
/// is about the time that waking up takes.
constexpr std::chrono::microseconds kSpin{40};
/// How long a caller that leaves a job waits for the workers to stop. The limit is needed because a
/// worker may wait for a lock that the caller holds, such as malloc's.
constexpr std::chrono::seconds kLeave{1};

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

/// Waits until `ready()` is true. Returns false if it is still false after kLeave.
template <typename Ready> bool waitFor(Ready ready) {
  const auto end = std::chrono::steady_clock::now() + kLeave;
  while (!ready()) {
    if (std::chrono::steady_clock::now() > end)
      return false;
    sched_yield();
  }
  return true;
}

/// Spins until `ready()` is true or kSpin has passed. Returns the last value of `ready()`.
template <typename Ready> bool spinFor(Ready ready) {
  for (int i = 0; i < 64; ++i) {
    if (ready())
      return true;
    pause();
  }
  const auto end = std::chrono::steady_clock::now() + kSpin;
  do {
    for (int i = 0; i < 16; ++i) {
      if (ready())
        return true;
      pause();
    }
  } while (std::chrono::steady_clock::now() < end);
  return ready();
}

int processors() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0)
    return std::clamp(CPU_COUNT(&set), 1, kMaxThreads);
  return std::clamp(int(std::thread::hardware_concurrency()), 1, kMaxThreads);
}

using Work = void (*)(void *, std::uint32_t);

/// The worker threads, which run one job at a time. A job is known by its number.
///
/// Each thread owns a share of the job's indices: a contiguous stretch, the same in every job of
/// that size. Data that it used last time may then still lie in its caches. A thread that has
/// finished its share takes indices from other shares. A share's ticket holds the job's number and
/// the next index. Before a new job is written, the tickets are reset, so a worker that is late for
/// the old job cannot take an index.
///
/// Nothing stops the workers when the process ends, and nothing waits for them. A signal handler
/// may have called exit() while a frame below it is inside a job. The workers end with the process.
/// What they use is never freed, and the library is never unmapped.
class Pool {
public:
  bool run(std::uint32_t count, Work work, void *argument, int threads) {
    if (m_busy.exchange(true, std::memory_order_acquire))
      return false;
    JumpGuard guard([this] { callOff(); });
    start(threads - 1);
    Progress progress;
    take(begin(count, work, argument, threads, false), 0, progress);
    const auto done = [this, count] { return m_done.load(std::memory_order_acquire) == count; };
    while (!spinFor(done)) {
      const std::uint32_t now = m_done.load(std::memory_order_acquire);
      if (now != count)
        m_done.wait(now, std::memory_order_acquire);
    }
    guard.done();
    m_busy.store(false, std::memory_order_release);
    return true;
  }

  /// Begins a job and returns its number, or 0 if none was begun.
  std::uint32_t post(std::uint32_t count, Work work, void *argument, int threads) {
    if (m_busy.exchange(true, std::memory_order_acquire))
      return 0;
    start(threads - 1);
    if (m_workers == 0) {
      m_busy.store(false, std::memory_order_release);
      return 0;
    }
    return begin(count, work, argument, threads, true);
  }
  [[nodiscard]] bool isOver(std::uint32_t job) const {
    return std::int32_t(m_over.load(std::memory_order_acquire) - job) >= 0;
  }
  void join(std::uint32_t job) {
    Progress progress;
    // The caller's half-done index counts as done; the workers do the rest.
    JumpGuard guard([&] {
      count(job, progress.done + (progress.isAtOne ? 1 : 0));
      leave(job);
    });
    takeAll(job, 0, progress);
    guard.done();
    count(job, progress.done);
    while (!spinFor([&] { return isOver(job); })) {
      const std::uint32_t now = m_over.load(std::memory_order_acquire);
      if (std::int32_t(now - job) < 0)
        m_over.wait(now, std::memory_order_acquire);
    }
  }
  /// Does the caller's part in a forked child, which has no workers. An index that a worker was at
  /// stays half done.
  void joinAlone(std::uint32_t job) {
    Progress progress;
    take(job, 0, progress);
  }
  void awaitPosted() const {
    waitFor([this] { return !m_isPosted.load(std::memory_order_acquire); });
  }

private:
  /// The progress of the caller, or of a worker, in a job.
  struct Progress {
    std::uint32_t done = 0; ///< indices
    bool isAtOne = false;
  };

  std::uint32_t begin(std::uint32_t count, Work work, void *argument, int threads, bool posted) {
    std::uint32_t job = m_job.load(std::memory_order_relaxed) + 1;
    job += job == 0; // 0 means no job
    for (int share = m_threads.load(std::memory_order_relaxed); share-- > 0;)
      m_shares[share].ticket.store(std::uint64_t(job) << 32 | kNoIndex, std::memory_order_relaxed);
    m_isPosted.store(posted, std::memory_order_relaxed);
    if (posted) // advances m_over, so that job numbers never wrap around past it
      noteOver(job - 1);
    m_done.store(0, std::memory_order_relaxed);
    m_count.store(count, std::memory_order_release);
    m_work.store(work, std::memory_order_release);
    m_argument.store(argument, std::memory_order_release);
    m_threads.store(threads, std::memory_order_release);
    for (int share = 0; share < threads; ++share)
      m_shares[share].ticket.store(std::uint64_t(job) << 32 | shareBegin(share, threads, count),
                                   std::memory_order_release);
    m_job.store(job, std::memory_order_release);
    m_job.notify_all();
    return job;
  }

  /// Waits until the posted job is over, at most kLeave.
  void leave(std::uint32_t job) const {
    waitFor([&] { return isOver(job); });
  }

  /// Cancels the job: no index is taken any more. Waits until no worker is at an index. If one
  /// still is after kLeave, the pool accepts no further job. May be called in signal handlers.
  void callOff() {
    const std::uint32_t job = m_job.load(std::memory_order_relaxed);
    for (Share &share : m_shares)
      // The default memory order keeps the loads below after this store.
      share.ticket.store(std::uint64_t(job) << 32 | kNoIndex);
    const auto idle = [this] {
      return std::none_of(std::begin(m_shares), std::end(m_shares),
                          [](const Share &share) { return share.isAtWork.load(); });
    };
    if (waitFor(idle))
      m_busy.store(false, std::memory_order_release);
  }

  void start(int workers) {
    for (; m_workers < workers && !m_refused; ++m_workers) {
      auto *const worker =
          new (std::nothrow) Worker{this, m_job.load(std::memory_order_relaxed), m_workers};
      if (worker && startThread("arbiter-raster", kWorkerStack, loop, worker))
        continue;
      delete worker;
      m_refused = true; // go on with the workers that exist
      return;
    }
  }

  struct Worker {
    Pool *pool;
    std::uint32_t seen; ///< the last job's number when the worker was started
    int index;
  };
  static void loop(void *argument) {
    const Worker worker = *static_cast<Worker *>(argument);
    delete static_cast<Worker *>(argument);
    worker.pool->loop(worker.seen, worker.index);
  }
  [[noreturn]] void loop(std::uint32_t seen, int index) {
    for (;;) {
      const auto changed = [&] { return m_job.load(std::memory_order_acquire) != seen; };
      if (!spinFor(changed))
        m_job.wait(seen, std::memory_order_acquire);
      seen = m_job.load(std::memory_order_acquire);
      const int share = index + 1;
      if (share >= m_threads.load(std::memory_order_relaxed))
        continue;
      // Set before an index is taken: callOff() withdraws the indices first and then reads this.
      m_shares[share].isAtWork.store(true);
      Progress progress;
      take(seen, share, progress);
      m_shares[share].isAtWork.store(false, std::memory_order_release);
    }
  }

  static std::uint32_t shareBegin(int share, int threads, std::uint32_t count) {
    return std::uint32_t(std::uint64_t(count) * unsigned(share) / unsigned(threads));
  }

  void take(std::uint32_t job, int own, Progress &progress) {
    takeAll(job, own, progress);
    count(job, progress.done);
  }
  /// Works on the thread's own share, then on the others.
  void takeAll(std::uint32_t job, int own, Progress &progress) {
    const int threads = m_threads.load(std::memory_order_acquire);
    for (int i = 0; i < threads; ++i)
      takeOf(job, (own + i) % threads, threads, progress);
  }

  /// Adds `done` to the number of finished indices; ends the job if it was the last.
  void count(std::uint32_t job, std::uint32_t done) {
    if (done == 0)
      return;
    // The job cannot end before this is added, so m_count still belongs to it.
    const std::uint32_t count = m_count.load(std::memory_order_relaxed);
    const bool isPosted = m_isPosted.load(std::memory_order_relaxed);
    if (m_done.fetch_add(done, std::memory_order_acq_rel) + done != count)
      return;
    if (!isPosted) {
      m_done.notify_one();
      return;
    }
    // A thread that sees the end of the job may post the next one at once.
    m_isPosted.store(false, std::memory_order_release);
    m_busy.store(false, std::memory_order_release);
    noteOver(job);
  }
  /// Records that `job` is over, unless another thread has recorded a later one.
  void noteOver(std::uint32_t job) {
    std::uint32_t last = m_over.load(std::memory_order_relaxed);
    while (std::int32_t(job - last) > 0 &&
           !m_over.compare_exchange_weak(last, job, std::memory_order_acq_rel,
                                         std::memory_order_relaxed))
      ;
    m_over.notify_all();
  }

  /// Takes indices of the share, one after the other, and works on them.
  void takeOf(std::uint32_t job, int share, int threads, Progress &progress) {
    std::atomic<std::uint64_t> &ticketOf = m_shares[share].ticket;
    std::uint64_t ticket = ticketOf.load(std::memory_order_acquire);
    const std::uint32_t count = m_count.load(std::memory_order_acquire);
    const Work work = m_work.load(std::memory_order_acquire);
    void *const argument = m_argument.load(std::memory_order_acquire);
    const std::uint32_t end = shareBegin(share + 1, threads, count);
    for (;; ++progress.done) {
      do {
        if (std::uint32_t(ticket >> 32) != job || std::uint32_t(ticket) >= end)
          return;
        // Success means that no newer job has begun, so the values read above belong to this job.
      } while (!ticketOf.compare_exchange_weak(ticket, ticket + 1, std::memory_order_acq_rel,
                                               std::memory_order_acquire));
      progress.isAtOne = true;
      work(argument, std::uint32_t(ticket));
      progress.isAtOne = false;
      ticket = ticketOf.load(std::memory_order_acquire);
    }
  }

  std::atomic<bool> m_busy{false};
  std::atomic<std::uint32_t> m_job{0};
  alignas(64) std::atomic<std::uint32_t> m_count{0};
  std::atomic<Work> m_work{nullptr};
  std::atomic<void *> m_argument{nullptr};
  /// threads that may take part, including the caller; the pool may have more
  std::atomic<int> m_threads{1};
  std::atomic<bool> m_isPosted{false}; ///< true if no caller waits for the job
  alignas(64) std::atomic<std::uint32_t> m_done{0};
  std::atomic<std::uint32_t> m_over{0}; ///< number of the last posted job that has ended
  static constexpr std::uint32_t kNoIndex = ~0u;
  struct alignas(64) Share {
    std::atomic<std::uint64_t> ticket{0};
    /// true while the worker of this share works, or looks for work
    std::atomic<bool> isAtWork{false};
  };
  Share m_shares[kMaxThreads];
  // Only the thread that has set m_busy uses the members below.
  bool m_refused = false;
  int m_workers = 0; ///< number of workers started
};

std::atomic<int> g_threads{0};
std::atomic<Pool *> g_pool{nullptr};

/// Replaces the pool in the child of a fork. The child has no workers, and the old pool's state
/// cannot be trusted, so it is leaked.
void afterFork() { g_pool.store(new (std::nothrow) Pool, std::memory_order_release); }

Pool *pool() {
  if (Pool *const existing = g_pool.load(std::memory_order_acquire))
    return existing;
  // std::call_once passes its function through thread-local variables, so a static is used.
  static const bool s_made = [] {
    g_pool.store(new (std::nothrow) Pool, std::memory_order_release);
    return pthread_atfork(awaitPosted, nullptr, afterFork) == 0;
  }();
  (void)s_made;
  return g_pool.load(std::memory_order_acquire);
}

} // namespace

void parallel(std::uint32_t count, void (*work)(void *argument, std::uint32_t i), void *argument) {
  const int threads = count > 1 ? int(std::min(count, std::uint32_t(threadCount()))) : 1;
  if (threads > 1) {
    Pool *const workers = pool();
    if (workers && workers->run(count, work, argument, threads))
      return;
  }
  for (std::uint32_t i = 0; i < count; ++i)
    work(argument, i);
}

PostedJob post(std::uint32_t count, void (*work)(void *argument, std::uint32_t i), void *argument) {
  const int threads = threadCount();
  Pool *const workers = threads > 1 && count > 0 ? pool() : nullptr;
  return {workers ? workers->post(count, work, argument, threads) : 0, workers};
}

bool isOver(const PostedJob &job) {
  return job.number == 0 || static_cast<Pool *>(job.pool)->isOver(job.number);
}

void join(const PostedJob &job) {
  if (isOver(job))
    return;
  auto *const workers = static_cast<Pool *>(job.pool);
  if (workers == pool())
    workers->join(job.number);
  else
    workers->joinAlone(job.number);
}

void awaitPosted() {
  if (Pool *const existing = g_pool.load(std::memory_order_acquire))
    existing->awaitPosted();
}

int threadCount() {
  if (const int threads = g_threads.load(std::memory_order_relaxed))
    return threads;
  const std::uint32_t asked = settings().threads;
  const int threads = asked ? int(std::min(asked, std::uint32_t(kMaxThreads))) : processors();
  g_threads.store(threads, std::memory_order_relaxed);
  return threads;
}

void setThreadCount(int count) {
  g_threads.store(std::clamp(count, 0, kMaxThreads), std::memory_order_relaxed);
}

} // namespace arbiter::swrast
