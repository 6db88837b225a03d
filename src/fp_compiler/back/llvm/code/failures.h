#pragma once
#include <exception>
#include <memory>
#include <stdexcept>

/// LLVM ends the process where it cannot go on: an error that it has no other way to report, memory
/// that is not there. The layer may not do that to an application, so on a thread of the layer's
/// these are exceptions while a FailureScope lives. LLVM is shared with the host's driver: on any
/// other thread, and outside such scopes, what happens is what LLVM does without this.
namespace arbiter::fp::llvm_back {

/// A fatal error of LLVM's; what() is its message. For memory it is std::bad_alloc.
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

/// Once LLVM failed in the middle of its work nothing is asked of it any more: locks and tables of
/// its own may be as they were at that moment.
[[nodiscard]] bool hasFailed();
void noteFailure();

/// Objects of LLVM's that an exception leaves where they are, never destroyed: code without
/// exceptions may have been about to change them. It is noted as a failure.
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
