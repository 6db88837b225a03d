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
/// Room for what a job calls; an application's limit of the stack's size says nothing of the
/// layer's needs.
constexpr std::size_t kWorkerStack = std::size_t(1) << 20;
/// How long a worker looks for the next job, and a caller for the last worker, before it sleeps:
/// as long as it takes to wake up again.
constexpr std::chrono::microseconds kSpin{40};
/// How long a caller that leaves a job waits for what the workers are at. A worker may need what
/// the caller holds, malloc's lock for one.
constexpr std::chrono::seconds kLeave{1};

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

/// What `ready` says, or false after kLeave.
template <typename Ready> bool waitFor(Ready ready) {
  const auto end = std::chrono::steady_clock::now() + kLeave;
  while (!ready()) {
    if (std::chrono::steady_clock::now() > end)
      return false;
    sched_yield();
  }
  return true;
}

/// Spins until `ready` or the time is over; returns what `ready` says.
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

/// A job is known by its number. Each thread has a share of the indices, one stretch, the same
/// stretch of every job of that size: what it wrote or read there last time may lie in its own
/// caches still. Who is through takes from the others' shares. A share's ticket holds the job's
/// number and the next index to be taken. Tickets of the job before are taken back before anything
/// of a new one is written, so that who comes late to a job that is over cannot take an index.
///
/// Nothing stops the workers when the process ends, and nothing waits for them: exit() may have
/// been called by a signal's handler, above a frame that holds a job half done. They end with the
/// process; what they use is never freed before (the library is not unmapped either).
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

  /// The job's number; 0 where there is none.
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
    // The caller's index, which is half done, counts as done: the others do the rest.
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
  /// Without its threads: what one of them was at stays half done.
  void joinAlone(std::uint32_t job) {
    Progress progress;
    take(job, 0, progress);
  }
  void awaitPosted() const {
    waitFor([this] { return !m_isPosted.load(std::memory_order_acquire); });
  }

private:
  /// A caller's part of a job.
  struct Progress {
    std::uint32_t done = 0; ///< indices
    bool isAtOne = false;
  };

  std::uint32_t begin(std::uint32_t count, Work work, void *argument, int threads, bool posted) {
    std::uint32_t job = m_job.load(std::memory_order_relaxed) + 1;
    job += job == 0; // is none
    for (int share = m_threads.load(std::memory_order_relaxed); share-- > 0;)
      m_shares[share].ticket.store(std::uint64_t(job) << 32 | kNoIndex, std::memory_order_relaxed);
    m_isPosted.store(posted, std::memory_order_relaxed);
    if (posted) // never so far back that numbers come round
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

  /// Until the posted job is over, or kLeave.
  void leave(std::uint32_t job) const {
    waitFor([&] { return isOver(job); });
  }

  /// No index is taken any more; returns when no worker is at one, or after kLeave: then the pool
  /// takes no job again. Also called in handlers.
  void callOff() {
    const std::uint32_t job = m_job.load(std::memory_order_relaxed);
    for (Share &share : m_shares)
      share.ticket.store(std::uint64_t(job) << 32 | kNoIndex); // orders the loads below after it
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
      m_refused = true; // as many as there are will do
      return;
    }
  }

  struct Worker {
    Pool *pool;
    std::uint32_t seen; ///< the job that was the last when it was started
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
      // Before it takes an index: callOff() takes the indices back, then asks.
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
  /// Works on the share, then on the others'.
  void takeAll(std::uint32_t job, int own, Progress &progress) {
    const int threads = m_threads.load(std::memory_order_acquire);
    for (int i = 0; i < threads; ++i)
      takeOf(job, (own + i) % threads, threads, progress);
  }

  /// So many indices more of the job are done.
  void count(std::uint32_t job, std::uint32_t done) {
    if (done == 0)
      return;
    // As long as this is not added the job is not over, and the count is its own.
    const std::uint32_t count = m_count.load(std::memory_order_relaxed);
    const bool isPosted = m_isPosted.load(std::memory_order_relaxed);
    if (m_done.fetch_add(done, std::memory_order_acq_rel) + done != count)
      return;
    if (!isPosted) {
      m_done.notify_one();
      return;
    }
    // Who knows that it is over may post the next one.
    m_isPosted.store(false, std::memory_order_release);
    m_busy.store(false, std::memory_order_release);
    noteOver(job);
  }
  /// Another thread may have noted a later one meanwhile.
  void noteOver(std::uint32_t job) {
    std::uint32_t last = m_over.load(std::memory_order_relaxed);
    while (std::int32_t(job - last) > 0 &&
           !m_over.compare_exchange_weak(last, job, std::memory_order_acq_rel,
                                         std::memory_order_relaxed))
      ;
    m_over.notify_all();
  }

  /// Does indices of the share.
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
        // Success says that no newer job was begun, so that what was read above is this one's.
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
  std::atomic<int> m_threads{1}; ///< that may take part, the caller's included: there may be more
  std::atomic<bool> m_isPosted{false}; ///< the job has no caller that waits
  alignas(64) std::atomic<std::uint32_t> m_done{0};
  std::atomic<std::uint32_t> m_over{0}; ///< the last posted job that is over
  static constexpr std::uint32_t kNoIndex = ~0u;
  struct alignas(64) Share {
    std::atomic<std::uint64_t> ticket{0};
    std::atomic<bool> isAtWork{false}; ///< the worker whose share it is, or it looks for work
  };
  Share m_shares[kMaxThreads];
  // Of who holds m_busy.
  bool m_refused = false;
  int m_workers = 0; ///< that were started
};

std::atomic<int> g_threads{0};
std::atomic<Pool *> g_pool{nullptr};

/// The child of a fork has none of the workers, and nothing of the old pool's state can be relied
/// on: it is left behind.
void afterFork() { g_pool.store(new (std::nothrow) Pool, std::memory_order_release); }

Pool *pool() {
  if (Pool *const existing = g_pool.load(std::memory_order_acquire))
    return existing;
  // Not by call_once, which hands the function over in variables of the thread.
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
