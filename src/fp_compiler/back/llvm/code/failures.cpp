#include "fp_compiler/back/llvm/code/failures.h"

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <new>
#include <unistd.h>

#include <llvm/Support/ErrorHandling.h>
#include <llvm/Support/Signals.h>

namespace arbiter::fp::llvm_back {

namespace {

thread_local int t_scopes = 0;
std::atomic<bool> g_failed{false};

/// Writes an error message as LLVM does (ErrorHandling.cpp), using nothing that may fail again.
void say(const char *first, const char *message, const char *last) {
  for (const char *part : {first, message, last})
    if (::write(STDERR_FILENO, part, std::strlen(part)) < 0)
      return;
}

void onFatalError(void *, const char *message, bool crashes) {
  if (t_scopes > 0)
    throw LlvmFailure(message);
  say("LLVM ERROR: ", message, "\n");
  llvm::sys::RunInterruptHandlers();
  if (crashes)
    std::abort();
  std::exit(1);
}

void onNoMemory(void *, const char *, bool) {
  if (t_scopes > 0)
    throw std::bad_alloc();
  say("LLVM ERROR: out of memory\n", "", "");
  std::abort();
}

} // namespace

FailureScope::FailureScope() {
  // The handlers are never removed. If the application installs its own later, those replace the
  // layer's.
  static std::once_flag s_once;
  std::call_once(s_once, [] {
    llvm::install_fatal_error_handler(onFatalError);
    llvm::install_bad_alloc_error_handler(onNoMemory);
  });
  ++t_scopes;
}

FailureScope::~FailureScope() { --t_scopes; }

bool hasFailed() { return g_failed.load(std::memory_order_relaxed); }

void noteFailure() { g_failed.store(true, std::memory_order_relaxed); }

} // namespace arbiter::fp::llvm_back
