#pragma once
#include <pthread.h>
#include <utility>

// glibc's, of its public ABI, whose header declares the buffer alone. What is pushed is called when
// longjmp() leaves the frame that holds the buffer (POSIX leaves open what destructors do then:
// glibc calls none).
extern "C" void _pthread_cleanup_push(_pthread_cleanup_buffer *buffer, void (*routine)(void *),
                                      void *argument);
extern "C" void _pthread_cleanup_pop(_pthread_cleanup_buffer *buffer, int execute);

namespace arbiter::swrast {

/// Calls `onLeft()` where its frame is left before done(): by a jump over it, as a signal's handler
/// makes by siglongjmp(), or by an exception.
template <typename OnLeft> class JumpGuard {
public:
  explicit JumpGuard(OnLeft onLeft) : m_onLeft(std::move(onLeft)) {
    _pthread_cleanup_push(
        &m_buffer, [](void *self) { static_cast<JumpGuard *>(self)->left(); }, this);
  }
  ~JumpGuard() {
    _pthread_cleanup_pop(&m_buffer, 0);
    left();
  }
  JumpGuard(const JumpGuard &) = delete;
  JumpGuard &operator=(const JumpGuard &) = delete;
  void done() { m_done = true; }

private:
  void left() {
    if (!std::exchange(m_done, true))
      m_onLeft();
  }
  OnLeft m_onLeft;
  bool m_done = false;
  _pthread_cleanup_buffer m_buffer;
};

} // namespace arbiter::swrast
