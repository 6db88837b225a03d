#include "swrast/image/storage.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <new>
#include <sys/mman.h>

namespace arbiter::swrast {
namespace {

constexpr std::size_t kGuardBytes = 64; ///< bytes before and after a block that may be read
constexpr std::size_t kHugePage = std::size_t(2) << 20;
/// Two cache lines, which processors fetch in pairs. No object of the layer has a larger alignment,
/// and safety/guarded_memory.cpp tells images from other objects by that.
constexpr std::size_t kBlockAlignment = 128;
constexpr std::size_t kPoolBlocks = 8;
/// the pool may exceed the bytes in use by this much
constexpr std::size_t kPoolBytes = std::size_t(16) << 20;
constexpr std::uint64_t kLargestBytes = std::min(std::uint64_t(1) << 40, Storage::kMaxBytes);

struct Freed {
  std::uint8_t *block = nullptr;
  std::size_t bytes = 0; ///< the requested size
};

/// The pool of freed blocks. Never destroyed, because images may outlive the library's static
/// objects.
struct Pool {
  std::mutex mutex;
  std::array<Freed, kPoolBlocks> freed; ///< oldest first
  std::size_t count = 0, freedBytes = 0, usedBytes = 0;
  std::array<void *, 32> handles; ///< freed memory of shared_ptr control blocks
  std::size_t handleCount = 0;
};
Pool &pool() {
  static Pool *const instance = new Pool;
  return *instance;
}
std::atomic<std::size_t> g_totalBytes{0};
std::atomic<std::uint64_t> g_mostBytes{Storage::kMaxBytes};

std::size_t blockBytes(std::size_t bytes) { return (bytes + 2 * kGuardBytes + 63) / 64 * 64; }

std::uint8_t *allocate(std::size_t bytes) {
  const std::size_t size = blockBytes(bytes);
  const bool huge = size >= 2 * kHugePage;
  void *block = nullptr;
  if (posix_memalign(&block, huge ? kHugePage : kBlockAlignment, size) != 0)
    return nullptr;
  // Huge pages save most of the address translation when an image is traversed. A kernel without
  // them fails the call, which does no harm.
  if (huge)
    (void)madvise(block, size, MADV_HUGEPAGE);
  return static_cast<std::uint8_t *>(block);
}

void release(const Freed &freed) {
  g_totalBytes.fetch_sub(blockBytes(freed.bytes), std::memory_order_relaxed);
  std::free(freed.block);
}

/// True if another block of that size is allowed; empties the pool first if that helps.
bool mayGrow(std::size_t bytes) {
  const auto fits = [bytes] {
    return g_totalBytes.load(std::memory_order_relaxed) + std::uint64_t(blockBytes(bytes)) <=
           g_mostBytes.load(std::memory_order_relaxed);
  };
  if (fits())
    return true;
  Pool &p = pool();
  const std::lock_guard lock(p.mutex);
  std::for_each_n(p.freed.begin(), p.count, release);
  p.count = p.freedBytes = 0;
  return fits();
}

/// Allocates shared_ptr control blocks from the pool, so that repeated use does not touch the heap.
template <typename T> struct HandleAllocator {
  using value_type = T;
  static constexpr std::size_t kBytes = 128;
  HandleAllocator() = default;
  template <typename Other> explicit HandleAllocator(const HandleAllocator<Other> &) {}
  T *allocate(std::size_t n) {
    static_assert(sizeof(T) <= kBytes);
    {
      const std::lock_guard lock(pool().mutex);
      if (n == 1 && pool().handleCount > 0)
        return static_cast<T *>(pool().handles[--pool().handleCount]);
    }
    return static_cast<T *>(::operator new(n *kBytes));
  }
  void deallocate(T *memory, std::size_t n) {
    {
      const std::lock_guard lock(pool().mutex);
      if (n == 1 && pool().handleCount < pool().handles.size()) {
        pool().handles[pool().handleCount++] = memory;
        return;
      }
    }
    ::operator delete(memory);
  }
  template <typename Other> bool operator==(const HandleAllocator<Other> &) const { return true; }
};

} // namespace

std::shared_ptr<Storage> Storage::make(std::uint64_t wanted) {
  if (wanted == 0 || wanted > kLargestBytes)
    return nullptr;
  const auto bytes = std::size_t(wanted);
  struct Made : Storage {
    Made(std::uint8_t *data, std::size_t size) : Storage(data, size) {}
  };
  std::uint8_t *block = nullptr;
  {
    Pool &p = pool();
    const std::lock_guard lock(p.mutex);
    // Takes the newest block, whose lines may still be in a cache.
    for (std::size_t i = p.count; i-- > 0 && !block;) {
      if (p.freed[i].bytes != bytes)
        continue;
      block = p.freed[i].block;
      p.freedBytes -= bytes;
      std::move(p.freed.begin() + std::ptrdiff_t(i) + 1, p.freed.begin() + std::ptrdiff_t(p.count),
                p.freed.begin() + std::ptrdiff_t(i));
      --p.count;
    }
    p.usedBytes += bytes;
  }
  const auto withdraw = [bytes] {
    const std::lock_guard lock(pool().mutex);
    pool().usedBytes -= bytes;
  };
  if (!block) {
    if (!mayGrow(bytes)) {
      withdraw();
      return nullptr;
    }
    block = allocate(bytes);
    if (!block) {
      withdraw();
      return nullptr;
    }
    g_totalBytes.fetch_add(blockBytes(bytes), std::memory_order_relaxed);
  }
  try {
    return std::allocate_shared<Made>(HandleAllocator<Made>(), block + kGuardBytes, bytes);
  } catch (const std::bad_alloc &) {
    release({block, bytes});
    withdraw();
    return nullptr;
  }
}

std::shared_ptr<Storage> Storage::wrap(std::uint8_t *data, std::size_t bytes, const Owner &owner,
                                       void *user) {
  struct Wrapped : Storage {
    Wrapped(std::uint8_t *data, std::size_t size) : Storage(data, size) {}
  };
  try {
    auto made = std::allocate_shared<Wrapped>(HandleAllocator<Wrapped>(), data, bytes);
    made->m_owner = &owner;
    made->m_user = user;
    return made;
  } catch (const std::bad_alloc &) {
    owner.release(user);
    return nullptr;
  }
}

bool Storage::deferClear(const ClearedPixels &pixels, const ClearPattern &pattern) {
  settle();
  if (!m_clear)
    m_clear.reset(DeferredClear::take());
  return m_clear && m_clear->begin(pixels, pattern);
}

Storage::~Storage() {
  settle();
  if (m_owner) {
    m_owner->release(m_user);
    return;
  }
  std::array<Freed, kPoolBlocks + 1> leaving;
  std::size_t leavingCount = 0;
  {
    Pool &p = pool();
    const std::lock_guard lock(p.mutex);
    p.usedBytes -= m_bytes;
    const std::size_t limit = p.usedBytes + kPoolBytes;
    const auto dropOldest = [&] {
      leaving[leavingCount++] = p.freed[0];
      p.freedBytes -= p.freed[0].bytes;
      std::move(p.freed.begin() + 1, p.freed.begin() + std::ptrdiff_t(p.count), p.freed.begin());
      --p.count;
    };
    while (p.count > 0 && (p.count == kPoolBlocks || p.freedBytes + m_bytes > limit))
      dropOldest();
    const Freed mine = {m_data - kGuardBytes, m_bytes};
    if (p.freedBytes + m_bytes <= limit) {
      p.freed[p.count++] = mine;
      p.freedBytes += m_bytes;
    } else {
      leaving[leavingCount++] = mine;
    }
  }
  std::for_each_n(leaving.begin(), leavingCount, release);
}

std::size_t Storage::totalBytes() { return g_totalBytes.load(std::memory_order_relaxed); }

std::uint64_t Storage::limitTotal(std::uint64_t bytes) { return g_mostBytes.exchange(bytes); }

} // namespace arbiter::swrast
