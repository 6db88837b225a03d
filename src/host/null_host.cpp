#include "host/null_host.h"

#include <dlfcn.h>

namespace arbiter::host {

namespace {

/// The calling thread is inside a call to the next definition.
constinit thread_local bool t_insideNullCall __attribute__((tls_model("initial-exec"))) = false;

bool inThisLibrary(const void *function) {
  Dl_info theirs, ours;
  return dladdr(function, &theirs) != 0 &&
         dladdr(reinterpret_cast<const void *>(&inThisLibrary), &ours) != 0 &&
         theirs.dli_fbase == ours.dli_fbase;
}

void *resolve(const char *name) {
  // dlerror belongs to the application: a miss of ours must not be what it reads next.
  void *function = dlsym(RTLD_NEXT, name);
  if (!function)
    function = dlsym(RTLD_DEFAULT, name);
  if (!function)
    (void)dlerror();
  return inThisLibrary(function) ? nullptr : function;
}

} // namespace

NullCall::NullCall(const char *name, std::atomic<void *> &next) {
  if (!name || t_insideNullCall)
    return;
  void *function = next.load(std::memory_order_acquire);
  if (!function) {
    function = resolve(name);
    next.store(function, std::memory_order_release);
  }
  if (function) {
    t_insideNullCall = true;
    m_function = function;
  }
}

NullCall::~NullCall() {
  if (m_function)
    t_insideNullCall = false;
}

} // namespace arbiter::host
