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
constexpr int kSmallest = 6; ///< log2 of the smallest block's size in bytes, with its header
constexpr int kSizes = 25 - kSmallest;

/// Precedes each allocated block.
struct alignas(16) Header {
  std::uint32_t size;   ///< log2 of the whole block's size in bytes
  std::uint32_t offset; ///< from the start of the block to the returned address
};
/// A block in a free list.
struct Free {
  Free *next;
};

alignas(64) std::byte g_memory[kBytes];

/// A spin lock, held for a few instructions. A libc mutex would not be usable before static objects
/// are constructed.
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

// The lock protects all of the following.
std::size_t g_used = 0; ///< bytes from the start that were split into blocks
std::size_t g_lent = 0; ///< bytes of blocks in use
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
  // Blocks are aligned to 64 bytes.
  const std::size_t slack = alignment > 64 ? alignment : 0;
  const std::size_t whole =
      bytes + (alignment > sizeof(Header) ? alignment : sizeof(Header)) + slack;
  auto size = int(std::bit_width(whole - 1));
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
