#pragma once
#include <array>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace sharing {

/// Threads that take turns: one works while the others and the caller wait. The caller thus
/// determines the order of all commands, and a thread's work happens before the next thread's.
class Workers {
public:
  static constexpr int kThreads = 3;
  Workers();
  ~Workers();
  Workers(const Workers &) = delete;
  Workers &operator=(const Workers &) = delete;
  /// Runs the work on thread `thread`; returns when it is done.
  void run(int thread, const std::function<void()> &work);

private:
  void loop(int thread);
  std::mutex m_mutex;
  std::condition_variable m_changed;
  const std::function<void()> *m_work = nullptr;
  int m_turn = -1; ///< the working thread; -1: the caller
  bool m_ends = false;
  std::array<std::thread, kThreads> m_threads;
};

} // namespace sharing
