#include "state/software/compile_thread.h"

#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <system_error>
#include <thread>

#include <unistd.h>

// What the compiler itself calls for thread-local destructors; of glibc, in no header.
extern "C" int __cxa_thread_atexit_impl(void (*function)(void *), void *argument, void *library);
extern "C" void *__dso_handle __attribute__((visibility("hidden")));

namespace arbiter::state::software {

namespace {

class Compiler {
public:
  bool add(std::function<void()> task) {
    const std::lock_guard lock(m_mutex);
    if (m_stopping || !start())
      return false;
    m_tasks.push_back(std::move(task));
    m_wake.notify_one();
    return true;
  }

  /// Until nothing waits and nothing is being made.
  void drain() {
    std::unique_lock lock(m_mutex);
    if (m_process == getpid())
      m_idle.wait(lock, [this] { return m_tasks.empty() && !m_busy; });
  }

  void await(std::chrono::milliseconds atMost) {
    std::unique_lock lock(m_mutex);
    if (m_process == getpid())
      m_idle.wait_for(lock, atMost, [this] { return m_tasks.empty() && !m_busy; });
  }

  /// At exit: the task at hand is finished, the others are given up. Machine code and its library
  /// must not go while a thread is in them.
  void stop() {
    {
      const std::lock_guard lock(m_mutex);
      m_stopping = true;
      m_tasks.clear();
      m_wake.notify_one();
    }
    if (m_process == getpid() && m_thread.joinable())
      m_thread.join();
  }

private:
  bool start() {
    if (m_thread.joinable())
      return true;
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    try {
      m_thread = std::thread([this] { run(); });
      m_process = getpid();
    } catch (const std::system_error &) {
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return m_thread.joinable();
  }

  void run() {
    std::unique_lock lock(m_mutex);
    while (!m_stopping) {
      if (m_tasks.empty()) {
        m_wake.wait(lock);
        continue;
      }
      const std::function<void()> task = std::move(m_tasks.front());
      m_tasks.pop_front();
      m_busy = true;
      lock.unlock();
      task();
      lock.lock();
      m_busy = false;
      m_idle.notify_all();
    }
  }

  std::mutex m_mutex;
  std::condition_variable m_wake, m_idle;
  std::deque<std::function<void()>> m_tasks;
  std::thread m_thread;
  pid_t m_process = 0;
  bool m_stopping = false;
  bool m_busy = false; ///< a task is run, without the lock
};

/// Never freed: contexts may draw in other libraries' destructors. A child of fork() has no thread
/// and perhaps a held lock, so it makes one anew and leaks its parent's.
Compiler &compiler() {
  static std::mutex s_mutex;
  static Compiler *s_compiler = nullptr;
  static pid_t s_process = 0;
  const std::lock_guard lock(s_mutex);
  if (!s_compiler || s_process != getpid()) {
    if (!s_compiler)
      std::atexit([] { compiler().stop(); });
    s_compiler = new Compiler;
    s_process = getpid();
  }
  return *s_compiler;
}

/// When a thread that draws ends, before any destructor of a static: LLVM's own are made while it
/// compiles, later than any handler of ours, and would go first under a running compilation.
void threadEnds(void *) {
  if (gettid() == getpid())
    compiler().stop(); // the process ends
  else
    compiler().drain(); // it may
}

} // namespace

bool compileLater(std::function<void()> task) {
  if (!compiler().add(std::move(task)))
    return false;
  // Once a task: a program is compiled once, so there are few.
  __cxa_thread_atexit_impl(threadEnds, nullptr, &__dso_handle);
  return true;
}

void awaitCompiler(std::chrono::milliseconds atMost) { compiler().await(atMost); }

} // namespace arbiter::state::software
