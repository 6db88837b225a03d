/// Makes the Nth allocation of the layer, its JIT library, or optionally LLVM on behalf of the JIT
/// library fail. It is preloaded before the layer. Allocations of the host and the application
/// always succeed, as their failure would end the process.
///
/// The client arms and disarms it (failing_memory.h). FAIL_LIBRARIES=llvm includes LLVM's.
#include "failing_memory.h"

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

#include <dlfcn.h>
#include <link.h>
#include <sys/ipc.h>
#include <sys/types.h>
#include <unwind.h>

// These are glibc's own functions beneath the ones replaced here; no header declares them.
extern "C" void *__libc_malloc(std::size_t);
extern "C" void *__libc_calloc(std::size_t, std::size_t);
extern "C" void *__libc_memalign(std::size_t, std::size_t);
extern "C" void *__libc_realloc(void *, std::size_t);
extern "C" void __libc_free(void *);

namespace {

/// The address range of a library's code.
struct Range {
  std::atomic<std::uintptr_t> begin{0}, end{0};
  [[nodiscard]] bool has(std::uintptr_t address) const {
    return address >= begin.load(std::memory_order_relaxed) &&
           address < end.load(std::memory_order_relaxed);
  }
};
Range g_layer, g_jit, g_llvm;

std::atomic<long> g_left{-1};    ///< allocations until one fails; negative: none will
std::atomic<long> g_made{0};     ///< since it was armed
std::atomic<long> g_failures{0}; ///< since it was armed
std::atomic<bool> g_armed{false}, g_forGood{false};

int take(dl_phdr_info *object, std::size_t, void *) {
  const char *const name = object->dlpi_name ? object->dlpi_name : "";
  Range *const range = std::strstr(name, "libGLX_arbiter.so")   ? &g_layer
                       : std::strstr(name, "libarbiter_jit.so") ? &g_jit
                       : std::strstr(name, "libLLVM-")          ? &g_llvm
                                                                : nullptr;
  if (!range)
    return 0;
  std::uintptr_t begin = UINTPTR_MAX, end = 0;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr) &part = object->dlpi_phdr[i];
    if (part.p_type != PT_LOAD)
      continue;
    const std::uintptr_t at = object->dlpi_addr + part.p_vaddr;
    begin = at < begin ? at : begin;
    end = at + part.p_memsz > end ? at + part.p_memsz : end;
  }
  range->begin = begin;
  range->end = end;
  return 0;
}

bool countsLlvm() {
  static const bool s_counts = [] {
    const char *const libraries = std::getenv("FAIL_LIBRARIES");
    return libraries && !std::strcmp(libraries, "llvm");
  }();
  return s_counts;
}

_Unwind_Reason_Code lookForJit(_Unwind_Context *context, void *found) {
  if (!g_jit.has(_Unwind_GetIP(context)))
    return _URC_NO_REASON;
  *static_cast<bool *>(found) = true;
  return _URC_END_OF_STACK;
}

/// True if LLVM compiles for the JIT library, not for the host.
bool isForJit() {
  thread_local bool s_asking = false; // unwinding may allocate
  if (s_asking)
    return false;
  s_asking = true;
  bool found = false;
  _Unwind_Backtrace(lookForJit, &found);
  s_asking = false;
  return found;
}

/// True if the allocation that `caller` requests must fail.
bool fails(void *caller) {
  if (!g_armed.load(std::memory_order_relaxed))
    return false;
  const auto address = reinterpret_cast<std::uintptr_t>(caller);
  if (!g_layer.has(address) && !g_jit.has(address) &&
      !(countsLlvm() && g_llvm.has(address) && isForJit()))
    return false;
  g_made.fetch_add(1, std::memory_order_relaxed);
  const long left = g_left.fetch_sub(1, std::memory_order_relaxed);
  if (left > 1 || (left < 1 && !g_forGood.load(std::memory_order_relaxed)))
    return false;
  g_failures.fetch_add(1, std::memory_order_relaxed);
  return true;
}

void *unlessFails(void *caller, std::size_t bytes) {
  if (!fails(caller))
    return __libc_malloc(bytes ? bytes : 1);
  errno = ENOMEM;
  return nullptr;
}

void *orThrow(void *block) {
  if (!block)
    throw std::bad_alloc();
  return block;
}

} // namespace

#define EXPORTED __attribute__((visibility("default")))
#define CALLER __builtin_return_address(0)

extern "C" {

EXPORTED void failing_memory_arm(long at, int forGood) {
  dl_iterate_phdr(take, nullptr);
  g_made = g_failures = 0;
  g_forGood = forGood != 0;
  g_left = at;
  g_armed = true;
}

EXPORTED long failing_memory_disarm(long *made) {
  g_armed = false;
  *made = g_made;
  return g_failures;
}

EXPORTED void *malloc(std::size_t bytes) noexcept { return unlessFails(CALLER, bytes); }

EXPORTED void *calloc(std::size_t count, std::size_t bytes) noexcept {
  if (!fails(CALLER))
    return __libc_calloc(count, bytes);
  errno = ENOMEM;
  return nullptr;
}

EXPORTED void *realloc(void *block, std::size_t bytes) noexcept {
  if (bytes == 0 || !fails(CALLER))
    return __libc_realloc(block, bytes);
  errno = ENOMEM;
  return nullptr;
}

EXPORTED int posix_memalign(void **out, std::size_t alignment, std::size_t bytes) noexcept {
  if (fails(CALLER))
    return ENOMEM;
  *out = __libc_memalign(alignment, bytes);
  return *out ? 0 : ENOMEM;
}

EXPORTED void *aligned_alloc(std::size_t alignment, std::size_t bytes) noexcept {
  if (!fails(CALLER))
    return __libc_memalign(alignment, bytes);
  errno = ENOMEM;
  return nullptr;
}

/// Replaced too, as programs check that all allocation functions come from one library.
EXPORTED std::size_t malloc_usable_size(void *block) noexcept {
  using Function = std::size_t (*)(void *);
  static const auto s_next = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "malloc_usable_size"));
  return s_next(block);
}

/// Allocates memory that is shared with the X server.
EXPORTED int shmget(key_t key, std::size_t bytes, int flags) noexcept {
  using Function = int (*)(key_t, std::size_t, int);
  static const auto s_next = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "shmget"));
  if (!fails(CALLER))
    return s_next(key, bytes, flags);
  errno = ENOMEM;
  return -1;
}

} // extern "C"

// Without these, libraries that share libstdc++.so would be seen as its operator new.
EXPORTED void *operator new(std::size_t bytes) { return orThrow(unlessFails(CALLER, bytes)); }
EXPORTED void *operator new[](std::size_t bytes) { return orThrow(unlessFails(CALLER, bytes)); }
EXPORTED void *operator new(std::size_t bytes, const std::nothrow_t &) noexcept {
  return unlessFails(CALLER, bytes);
}
EXPORTED void *operator new[](std::size_t bytes, const std::nothrow_t &) noexcept {
  return unlessFails(CALLER, bytes);
}
EXPORTED void *operator new(std::size_t bytes, std::align_val_t alignment) {
  return orThrow(fails(CALLER) ? nullptr : __libc_memalign(std::size_t(alignment), bytes));
}
EXPORTED void operator delete(void *block) noexcept { __libc_free(block); }
EXPORTED void operator delete[](void *block) noexcept { __libc_free(block); }
EXPORTED void operator delete(void *block, std::size_t) noexcept { __libc_free(block); }
EXPORTED void operator delete[](void *block, std::size_t) noexcept { __libc_free(block); }
EXPORTED void operator delete(void *block, std::align_val_t) noexcept { __libc_free(block); }
EXPORTED void operator delete(void *block, std::size_t, std::align_val_t) noexcept {
  __libc_free(block);
}
