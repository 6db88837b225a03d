#include "host/null_host.h"

#include <array>
#include <dlfcn.h>
#include <iterator>

#include "util/cache/sealed.h"

namespace arbiter::host {

namespace {

/// True while the calling thread is inside a call to the next definition.
constinit thread_local bool t_insideNullCall __attribute__((tls_model("initial-exec"))) = false;

/// The functions that follow this library's in lookup order. Each is stored when it is found.
constinit Sealed<std::array<void *, kFunctions + std::size(HostTable{}.lazy)>> g_next;

bool inThisLibrary(const void *function) {
  Dl_info found, own;
  return dladdr(function, &found) != 0 &&
         dladdr(reinterpret_cast<const void *>(&inThisLibrary), &own) != 0 &&
         found.dli_fbase == own.dli_fbase;
}

void *resolve(const char *name) {
  // dlerror belongs to the application: it must not report the misses of this search.
  void *function = dlsym(RTLD_NEXT, name);
  if (!function)
    function = dlsym(RTLD_DEFAULT, name);
  if (!function)
    (void)dlerror();
  return inThisLibrary(function) ? nullptr : function;
}

} // namespace

NullCall::NullCall(const char *name, std::size_t index) {
  if (!name || t_insideNullCall)
    return;
  void *function = __atomic_load_n(&(*g_next)[index], __ATOMIC_ACQUIRE);
  if (!function) {
    function = resolve(name);
    // A function that cannot be stored now is looked up again at the next call.
    if (function)
      (void)g_next.amend(
          [&](auto &next) { __atomic_store_n(&next[index], function, __ATOMIC_RELEASE); });
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
