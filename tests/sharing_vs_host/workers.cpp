#include "workers.h"

namespace sharing {

Workers::Workers() {
  for (int i = 0; i < kThreads; ++i)
    m_threads[std::size_t(i)] = std::thread(&Workers::loop, this, i);
}

Workers::~Workers() {
  {
    const std::lock_guard lock(m_mutex);
    m_ends = true;
  }
  m_changed.notify_all();
  for (std::thread &thread : m_threads)
    thread.join();
}

void Workers::run(int thread, const std::function<void()> &work) {
  std::unique_lock lock(m_mutex);
  m_work = &work;
  m_turn = thread;
  m_changed.notify_all();
  m_changed.wait(lock, [this] { return m_turn < 0; });
}

void Workers::loop(int thread) {
  std::unique_lock lock(m_mutex);
  for (;;) {
    m_changed.wait(lock, [&] { return m_ends || m_turn == thread; });
    if (m_turn != thread)
      return;
    (*m_work)();
    m_turn = -1;
    m_changed.notify_all();
  }
}

} // namespace sharing
