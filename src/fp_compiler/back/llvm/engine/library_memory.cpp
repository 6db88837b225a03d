/// Replacements of malloc and related functions, for all objects linked into this library,
/// including LLVM and the C++ library (the linker's --wrap). They call the process's functions, and
/// use the reserve if those fail.
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <malloc.h>

#include "fp_compiler/back/llvm/engine/reserve.h"

namespace reserve = arbiter::fp::llvm_back::reserve;

#define HIDDEN __attribute__((visibility("hidden")))

extern "C" {

void *__real_malloc(std::size_t bytes);
void *__real_calloc(std::size_t count, std::size_t bytes);
void *__real_realloc(void *block, std::size_t bytes);
void __real_free(void *block);
void *__real_aligned_alloc(std::size_t alignment, std::size_t bytes);
int __real_posix_memalign(void **out, std::size_t alignment, std::size_t bytes);
}

namespace {
/// Returns the readable size of a block of the process. Returns 0 if malloc and
/// malloc_usable_size() come from different libraries.
std::size_t sizeInProcess(void *block) {
  Dl_info maker, teller;
  if (!dladdr(reinterpret_cast<void *>(&__real_malloc), &maker) ||
      !dladdr(reinterpret_cast<void *>(&malloc_usable_size), &teller) ||
      maker.dli_fbase != teller.dli_fbase)
    return 0;
  return malloc_usable_size(block);
}
} // namespace

extern "C" {

HIDDEN void *__wrap_malloc(std::size_t bytes) {
  void *const block = __real_malloc(bytes);
  return block ? block : reserve::allocate(bytes);
}

HIDDEN void *__wrap_calloc(std::size_t count, std::size_t bytes) {
  if (void *const block = __real_calloc(count, bytes))
    return block;
  std::size_t all = 0;
  if (__builtin_mul_overflow(count, bytes, &all))
    return nullptr;
  void *const block = reserve::allocate(all);
  return block ? std::memset(block, 0, all) : nullptr;
}

HIDDEN void __wrap_free(void *block) {
  if (reserve::has(block))
    reserve::release(block);
  else
    __real_free(block);
}

HIDDEN void *__wrap_realloc(void *block, std::size_t bytes) {
  if (!block)
    return __wrap_malloc(bytes);
  const bool inReserve = reserve::has(block);
  if (!inReserve)
    if (void *const moved = __real_realloc(block, bytes); moved || bytes == 0)
      return moved;
  const std::size_t had = inReserve ? reserve::sizeOf(block) : sizeInProcess(block);
  if (had == 0)
    return nullptr;
  if (bytes != 0 && bytes <= had)
    return block;
  void *const moved = bytes == 0 ? nullptr : __wrap_malloc(bytes);
  if (moved)
    std::memcpy(moved, block, had);
  if (moved || bytes == 0)
    __wrap_free(block);
  return moved;
}

HIDDEN void *__wrap_aligned_alloc(std::size_t alignment, std::size_t bytes) {
  void *const block = __real_aligned_alloc(alignment, bytes);
  return block ? block : reserve::allocate(bytes, alignment);
}

HIDDEN int __wrap_posix_memalign(void **out, std::size_t alignment, std::size_t bytes) {
  const int status = __real_posix_memalign(out, alignment, bytes);
  if (status != ENOMEM)
    return status;
  void *const block = reserve::allocate(bytes, alignment);
  if (block)
    *out = block;
  return block ? 0 : ENOMEM;
}

} // extern "C"
