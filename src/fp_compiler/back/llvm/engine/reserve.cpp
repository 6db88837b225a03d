#include "fp_compiler/back/llvm/engine/reserve.h"

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <limits>

#include <sched.h>

namespace arbiter::fp::llvm_back::reserve {

namespace {

constexpr std::size_t kBytes = std::size_t(16) << 20;
constexpr int kSmallest = 6; ///< the logarithm of the smallest block's bytes, its header included
constexpr int kSizes = 25 - kSmallest;

/// Before each block that is handed out.
struct alignas(16) Header {
  std::uint32_t size;   ///< the logarithm of the whole block's bytes
  std::uint32_t offset; ///< from where the whole block begins to what was handed out
};
/// A block that was given back.
struct Free {
  Free *next;
};

alignas(64) std::byte g_memory[kBytes];

/// Held for some instructions; a mutex of libc's could not be had before static objects are made.
class Lock {
public:
  Lock() {
    while (s_held.test_and_set(std::memory_order_acquire))
      sched_yield();
  }
  ~Lock() { s_held.clear(std::memory_order_release); }
  Lock(const Lock &) = delete;
  Lock &operator=(const Lock &) = delete;

private:
  static inline std::atomic_flag s_held = ATOMIC_FLAG_INIT;
};

// All of them under the lock.
std::size_t g_used = 0; ///< bytes from the start that blocks were made of
std::size_t g_lent = 0; ///< bytes of blocks that are in use
std::array<Free *, kSizes> g_free;

const Header &headerOf(const void *block) { return static_cast<const Header *>(block)[-1]; }

std::byte *take(int size) {
  Free *&first = g_free[std::size_t(size - kSmallest)];
  if (Free *const block = first) {
    first = block->next;
    return reinterpret_cast<std::byte *>(block);
  }
  const std::size_t bytes = std::size_t(1) << size;
  if (bytes > kBytes - g_used)
    return nullptr;
  std::byte *const block = g_memory + g_used;
  g_used += bytes;
  return block;
}

} // namespace

void *allocate(std::size_t bytes, std::size_t alignment) {
  if (bytes > kBytes || alignment > kBytes)
    return nullptr;
  if (alignment < alignof(Header))
    alignment = alignof(Header);
  // Blocks begin at multiples of 64.
  const std::size_t slack = alignment > 64 ? alignment : 0;
  const std::size_t whole =
      bytes + (alignment > sizeof(Header) ? alignment : sizeof(Header)) + slack;
  int size = std::bit_width(whole - 1);
  size = size < kSmallest ? kSmallest : size;
  if (size >= kSmallest + kSizes)
    return nullptr;
  const Lock lock;
  std::byte *const block = take(size);
  if (!block)
    return nullptr;
  g_lent += std::size_t(1) << size;
  const auto begin = reinterpret_cast<std::uintptr_t>(block);
  const std::uintptr_t at = (begin + sizeof(Header) + alignment - 1) & ~(alignment - 1);
  std::byte *const handed = block + (at - begin);
  reinterpret_cast<Header *>(handed)[-1] = {std::uint32_t(size), std::uint32_t(at - begin)};
  return handed;
}

bool has(const void *block) {
  return reinterpret_cast<std::uintptr_t>(block) - reinterpret_cast<std::uintptr_t>(g_memory) <
         kBytes;
}

void release(void *block) {
  const Header header = headerOf(block);
  auto *const whole = reinterpret_cast<Free *>(static_cast<std::byte *>(block) - header.offset);
  const Lock lock;
  g_lent -= std::size_t(1) << header.size;
  if (g_lent == 0) {
    g_used = 0;
    g_free = {};
    return;
  }
  Free *&first = g_free[header.size - kSmallest];
  whole->next = first;
  first = whole;
}

std::size_t sizeOf(const void *block) {
  const Header &header = headerOf(block);
  return (std::size_t(1) << header.size) - header.offset;
}

bool isLow() {
  const Lock lock;
  return g_used > kBytes / 4;
}

} // namespace arbiter::fp::llvm_back::reserve
