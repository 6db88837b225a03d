// Determines what a handler interrupted, by its stack, and by malloc, which is the program's own.
#include "watch.h"

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <initializer_list>

#include <dlfcn.h>
#include <execinfo.h>
#include <link.h>
#include <pthread.h>
#include <unistd.h>

#include "foreign.h"

extern "C" {
void *__libc_malloc(std::size_t bytes);
void *__libc_calloc(std::size_t count, std::size_t bytes);
void *__libc_realloc(void *block, std::size_t bytes);
void *__libc_memalign(std::size_t alignment, std::size_t bytes);
void __libc_free(void *block);
}

namespace foreign {

namespace {

__thread int t_allocations __attribute__((tls_model("initial-exec"))) = 0;
__thread bool t_watched __attribute__((tls_model("initial-exec"))) = false;

enum class Owner { Program, Libc, Layer, Other };

/// Returns whose code is at an address. Takes no lock, as handlers call it.
Owner ownerOf(void *address) {
  dl_find_object found = {};
  if (_dl_find_object(address, &found) != 0)
    return Owner::Other; // machine code that was made at run time
  const char *const path = found.dlfo_link_map->l_name;
  if (!*path)
    return Owner::Program;
  const char *const slash = std::strrchr(path, '/');
  const char *const name = slash ? slash + 1 : path;
  const auto starts = [&](const char *text) {
    return std::strncmp(name, text, std::strlen(text)) == 0;
  };
  if (starts("libGLX_arbiter") || starts("libarbiter_"))
    return Owner::Layer;
  // linux-gate is the kernel's page by which 32-bit code makes calls and returns from handlers.
  for (const char *const libc :
       {"libc.so", "linux-gate.so", "libGL.so", "libGLX.so", "libEGL.so", "libGLdispatch"})
    if (starts(libc))
      return Owner::Libc;
  return Owner::Other;
}

/// The frames that a handler interrupted: whether the layer's or the host's are among them.
struct Interrupted {
  bool whole = false, host = false, layer = false;
};
Interrupted lookAtFrames() {
  void *frames[96];
  const int count = backtrace(frames, 96);
  Interrupted seen;
  for (int i = 0; i < count; ++i) {
    const Owner owner = ownerOf(frames[i]);
    seen.host = seen.host || owner == Owner::Other;
    seen.layer = seen.layer || owner == Owner::Layer;
  }
  // A thread's stack begins in libc. If the unwound one does not, unwinding stopped in machine
  // code.
  seen.whole = count > 3 && count < 96 && ownerOf(frames[count - 1]) == Owner::Program;
  return seen;
}

/// Ends a watched thread's process if the layer, at exit, does something that may wait forever.
void check(void *caller, const char *what) {
  if (!t_watched || ownerOf(caller) != Owner::Layer)
    return;
  t_watched = false;
  dprintf(2, "foreign: the layer %s at exit\n", what);
  _exit(9);
}

/// Marks an allocation by this thread, or another operation that handlers must not look into.
class Allocation {
public:
  explicit Allocation(void *caller) {
    ++t_allocations;
    check(caller, "allocates or frees");
  }
  ~Allocation() { --t_allocations; }
  Allocation(const Allocation &) = delete;
  Allocation &operator=(const Allocation &) = delete;
};

/// Returns libc's own function, which this program's hides.
template <typename Function> Function realOf(std::atomic<Function> &kept, const char *name) {
  if (!kept.load())
    kept = reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
  return kept.load();
}

} // namespace

void prepareWatch() {
  static_cast<void>(lookAtFrames()); // the first backtrace() loads a library
  // The libraries must call this program's functions: otherwise a handler does not see an
  // allocation in progress, and leaves libc's lock locked.
  for (const char *const name :
       {"malloc", "calloc", "realloc", "memalign", "aligned_alloc", "posix_memalign", "free",
        "__register_frame", "__deregister_frame", "pthread_mutex_lock", "pthread_join"})
    need(ownerOf(dlsym(RTLD_DEFAULT, name)) == Owner::Program, name);
}

bool isLayerLoaded() { return dlopen("libGLX_arbiter.so.0", RTLD_LAZY | RTLD_NOLOAD) != nullptr; }

bool interruptedOutsideHost() {
  if (t_allocations != 0)
    return false;
  const Interrupted seen = lookAtFrames();
  return seen.whole && !seen.host;
}

bool interruptedInLayer() { return interruptedOutsideHost() && lookAtFrames().layer; }

void watchLayer() { t_watched = true; }

} // namespace foreign

using foreign::Allocation;

#pragma GCC visibility push(default) // the libraries' calls arrive here
extern "C" {
void *malloc(std::size_t bytes) {
  const Allocation allocation(__builtin_return_address(0));
  return __libc_malloc(bytes);
}
void *calloc(std::size_t count, std::size_t bytes) {
  const Allocation allocation(__builtin_return_address(0));
  return __libc_calloc(count, bytes);
}
void *realloc(void *block, std::size_t bytes) {
  const Allocation allocation(__builtin_return_address(0));
  return __libc_realloc(block, bytes);
}
void *memalign(std::size_t alignment, std::size_t bytes) {
  const Allocation allocation(__builtin_return_address(0));
  return __libc_memalign(alignment, bytes);
}
void *aligned_alloc(std::size_t alignment, std::size_t bytes) {
  const Allocation allocation(__builtin_return_address(0));
  return __libc_memalign(alignment, bytes);
}
int posix_memalign(void **block, std::size_t alignment, std::size_t bytes) {
  const Allocation allocation(__builtin_return_address(0));
  void *const made = __libc_memalign(alignment, bytes);
  if (!made)
    return ENOMEM;
  *block = made;
  return 0;
}
void free(void *block) {
  const Allocation allocation(__builtin_return_address(0));
  __libc_free(block);
}
// LLVM registers its code with libgcc under a lock that backtrace() takes as well.
void __register_frame(void *frame) {
  static std::atomic<void (*)(void *)> s_real;
  const Allocation busy(nullptr);
  foreign::realOf(s_real, "__register_frame")(frame);
}
void __deregister_frame(void *frame) {
  static std::atomic<void (*)(void *)> s_real;
  const Allocation busy(nullptr);
  foreign::realOf(s_real, "__deregister_frame")(frame);
}
int pthread_mutex_lock(pthread_mutex_t *mutex) noexcept {
  foreign::check(__builtin_return_address(0), "locks a mutex");
  static std::atomic<int (*)(pthread_mutex_t *)> s_real;
  return foreign::realOf(s_real, "pthread_mutex_lock")(mutex);
}
int pthread_join(pthread_t thread, void **result) {
  foreign::check(__builtin_return_address(0), "joins a thread");
  static std::atomic<decltype(&pthread_join)> s_real;
  return foreign::realOf(s_real, "pthread_join")(thread, result);
}
}
#pragma GCC visibility pop
