#pragma once
#include <array>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace sharing {

/// Threads that take turns: one works while the others, and the caller, wait. So the order of all
/// commands is the caller's, and what one did happens before the next one's work.
class Workers {
public:
  static constexpr int kThreads = 3;
  Workers();
  ~Workers();
  Workers(const Workers &) = delete;
  Workers &operator=(const Workers &) = delete;
  /// Does the work on thread `thread`; returns when it is done.
  void run(int thread, const std::function<void()> &work);

private:
  void loop(int thread);
  std::mutex m_mutex;
  std::condition_variable m_changed;
  const std::function<void()> *m_work = nullptr;
  int m_turn = -1; ///< whose work it is; -1: the caller's turn
  bool m_ends = false;
  std::array<std::thread, kThreads> m_threads;
};

} // namespace sharing
