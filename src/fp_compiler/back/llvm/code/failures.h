#pragma once
#include <exception>
#include <memory>
#include <stdexcept>

/// Turns fatal LLVM errors into exceptions. LLVM ends the process on errors that it cannot report
/// otherwise and when memory runs out. The layer must not do that to an application. On a thread
/// with a live FailureScope, these errors are exceptions. The host's driver shares LLVM, so on
/// other threads and outside scopes LLVM behaves as usual.
namespace arbiter::fp::llvm_back {

/// A fatal error of LLVM; what() returns its message. Out of memory is std::bad_alloc.
struct LlvmFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class FailureScope {
public:
  FailureScope();
  ~FailureScope();
  FailureScope(const FailureScope &) = delete;
  FailureScope &operator=(const FailureScope &) = delete;
};

/// True if LLVM failed in the middle of its work. It must not be used any more, because its locks
/// and tables may be in an inconsistent state.
[[nodiscard]] bool hasFailed();
void noteFailure();

/// Owns an LLVM object, but leaks it if an exception passes. Code without exception support may
/// have left it inconsistent, so that it must not be destroyed. This also counts as a failure.
template <typename T> class Kept {
public:
  template <typename... Arguments>
  explicit Kept(Arguments &&...arguments)
      : m_object(std::make_unique<T>(std::forward<Arguments>(arguments)...)) {}
  ~Kept() {
    if (std::uncaught_exceptions() == m_exceptions)
      return;
    (void)m_object.release();
    noteFailure();
  }
  Kept(const Kept &) = delete;
  Kept &operator=(const Kept &) = delete;
  T &operator*() const { return *m_object; }
  T *operator->() const { return m_object.get(); }

private:
  int m_exceptions = std::uncaught_exceptions();
  std::unique_ptr<T> m_object;
};

} // namespace arbiter::fp::llvm_back
