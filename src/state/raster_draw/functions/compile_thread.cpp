#include "state/raster_draw/functions/compile_thread.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <iterator>
#include <mutex>
#include <new>
#include <thread>

#include <pthread.h>
#include <unistd.h>

#include "util/flags.h"
#include "util/thread.h"

namespace arbiter::state {

namespace {

/// Stack size. LLVM recurses as deep as a program's dependencies. Pages that are not reached take
/// no memory.
constexpr std::size_t kStack = std::size_t(16) << 20;
/// The delay of each task with ARBITER_DEBUG=late-code. It is longer than a draw waits that can do
/// without the code (functions.cpp).
constexpr std::chrono::milliseconds kLate{60};
/// Tasks that wait for the first frame's end wait no longer than this, because a frame may never
/// end.
constexpr std::chrono::milliseconds kLongestFrame{500};

std::atomic<bool> g_frameEnded{false};

class Compiler {
public:
  bool add(std::function<void()> task, When when) {
    const std::lock_guard lock(m_mutex);
    if (!m_started)
      m_started = startThread(
          "arbiter-compile", kStack, [](void *self) { static_cast<Compiler *>(self)->run(); },
          this);
    if (!m_started)
      return false;
    if (when == When::AfterFrame && !m_released) {
      if (m_patient.empty())
        m_deadline = std::chrono::steady_clock::now() + kLongestFrame;
      m_patient.push_back(std::move(task));
    } else {
      m_tasks.push_back(std::move(task));
    }
    m_wake.notify_one();
    return true;
  }

  void release() {
    const std::lock_guard lock(m_mutex);
    releaseLocked();
  }

  void await(std::optional<std::chrono::milliseconds> atMost) {
    std::unique_lock lock(m_mutex);
    releaseLocked();
    const auto idle = [this] { return m_tasks.empty() && !m_busy; };
    if (!m_started)
      return;
    if (atMost)
      m_idle.wait_for(lock, *atMost, idle);
    else
      m_idle.wait(lock, idle);
  }

private:
  void releaseLocked() {
    m_released = true;
    m_tasks.insert(m_tasks.end(), std::make_move_iterator(m_patient.begin()),
                   std::make_move_iterator(m_patient.end()));
    m_patient.clear();
    m_wake.notify_one();
  }

  [[noreturn]] void run() {
    std::unique_lock lock(m_mutex);
    for (;;) {
      if (m_tasks.empty() && m_patient.empty()) {
        m_wake.wait(lock);
        continue;
      }
      if (m_tasks.empty()) {
        if (m_wake.wait_until(lock, m_deadline) == std::cv_status::timeout && !m_patient.empty())
          releaseLocked();
        continue;
      }
      const std::function<void()> task = std::move(m_tasks.front());
      m_tasks.pop_front();
      m_busy = true;
      lock.unlock();
      if (debugFlag(DebugFlag::LateCode))
        std::this_thread::sleep_for(kLate);
      try {
        task();
      } catch (const std::exception &) { // no memory, and no caller to tell
      }
      lock.lock();
      m_busy = false;
      m_idle.notify_all();
    }
  }

  std::mutex m_mutex;
  std::condition_variable m_wake, m_idle;
  std::deque<std::function<void()>> m_tasks;
  std::deque<std::function<void()>> m_patient; ///< tasks for after the first frame
  std::chrono::steady_clock::time_point m_deadline;
  bool m_released = g_frameEnded.load(); ///< true once the first frame has ended
  bool m_started = false;
  bool m_busy = false; ///< true while a task runs, without the lock
};

std::atomic<Compiler *> g_compiler{nullptr};

/// The process's compiler. Never freed: contexts may draw in other libraries' destructors, and the
/// thread runs until the process ends. A forked child has no thread, and perhaps a locked mutex. It
/// makes a new compiler and leaks the parent's.
Compiler *compiler() {
  if (Compiler *const existing = g_compiler.load(std::memory_order_acquire))
    return existing;
  static const int s_forks = pthread_atfork(
      nullptr, nullptr, [] { g_compiler.store(nullptr, std::memory_order_release); });
  (void)s_forks;
  auto *made = new (std::nothrow) Compiler;
  Compiler *other = nullptr;
  if (!made || g_compiler.compare_exchange_strong(other, made, std::memory_order_acq_rel))
    return made;
  delete made;
  return other;
}

} // namespace

bool compileLater(std::function<void()> task, When when) {
  const NoCancel scope;
  Compiler *const own = compiler();
  return own && own->add(std::move(task), when);
}

void frameEndsForCompiler() {
  if (g_frameEnded.load(std::memory_order_relaxed) || g_frameEnded.exchange(true))
    return;
  const NoCancel scope;
  if (Compiler *const own = g_compiler.load(std::memory_order_acquire))
    own->release();
}

void awaitCompiler(std::optional<std::chrono::milliseconds> atMost) {
  const NoCancel scope;
  if (Compiler *const own = compiler())
    own->await(atMost);
}

} // namespace arbiter::state
