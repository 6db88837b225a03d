#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>

#include "swrast/image/deferred_clear.h"

/// The memory of images, and the pool of freed blocks.
namespace arbiter::swrast {

/// Draws that have been queued and not been done yet.
class PendingDraws {
public:
  /// Does all of them before it returns.
  virtual void finish() = 0;
  /// Has the worker threads begin with them, if there are any.
  virtual void post() = 0;

protected:
  ~PendingDraws() = default;
};

/// The queued draws that read or write a storage.
struct PendingUse {
  PendingDraws *draws = nullptr; ///< the queue that holds them; null: none
  std::uint32_t batch = 0;       ///< number of the last batch that uses the storage
  bool isDrawnTo = false;        ///< true if that batch draws to it
  bool isSampled = false;        ///< true if that batch samples it
};

/// A block of memory that images share. 64 bytes before and after it may be read. Freed blocks go
/// to a small pool, so that alternating between two buffers allocates nothing.
class Storage {
public:
  /// Returns a block of undefined bytes, or null if there is no memory or the total limit is
  /// reached.
  [[nodiscard]] static std::shared_ptr<Storage> make(std::uint64_t bytes);
  /// The owner of memory that images use but no Storage has allocated.
  struct Owner {
    void (*release)(void *user); ///< called when the last image lets go of the memory
    /// True if another reader still has to read what was written; the memory may not be written
    /// before that is done.
    /// \param wait first waits for the reader
    bool (*isRead)(void *user, bool wait);
  };
  /// Wraps memory of another owner. On failure the owner's release() is called at once. Requires
  /// that 64 bytes before and after the memory may be read.
  [[nodiscard]] static std::shared_ptr<Storage> wrap(std::uint8_t *data, std::size_t bytes,
                                                     const Owner &owner, void *user);
  ~Storage();
  Storage(const Storage &) = delete;
  Storage &operator=(const Storage &) = delete;
  [[nodiscard]] std::uint8_t *data() const { return m_data; } ///< aligned to 64 bytes
  [[nodiscard]] std::size_t bytes() const { return m_bytes; }
  /// True if the owner's reader still reads the memory; false without an owner.
  [[nodiscard]] bool isRead() const { return m_owner && m_owner->isRead(m_user, false); }
  /// Waits until the memory may be written again.
  void awaitReader() const {
    if (m_owner)
      (void)m_owner->isRead(m_user, true);
  }
  /// Finishes the queued draws that use the memory. Call it before anyone but a queued draw reads,
  /// writes or frees it.
  void settle() const {
    if (m_use.draws) [[unlikely]]
      m_use.draws->finish();
  }
  [[nodiscard]] PendingUse &pendingUse() { return m_use; }
  /// Returns the clear that is still to be written, in part, or null. Queued draws may write it.
  [[nodiscard]] DeferredClear *pendingClear() const {
    return m_clear && m_clear->isPending() ? m_clear.get() : nullptr;
  }
  /// Notes a clear without writing it. Returns false if there is no memory for that.
  [[nodiscard]] bool deferClear(const ClearedPixels &pixels, const ClearPattern &pattern);
  /// Drops a pending clear. Call it when the whole memory is about to be replaced.
  void forgetClear() {
    settle();
    if (m_clear)
      m_clear->forget();
  }
  /// Returns the bytes that all storages hold now, including the pool.
  [[nodiscard]] static std::size_t totalBytes();
  /// Limit of the bytes that all storages may hold, including the pool. A 32-bit process may use an
  /// eighth of its addresses: an application ends if it or the host's driver cannot map memory.
  static constexpr std::uint64_t kMaxBytes = std::uint64_t(1) << (sizeof(void *) == 4 ? 29 : 46);
  /// Sets the limit, for tests. \returns the limit before
  static std::uint64_t limitTotal(std::uint64_t bytes);

protected:
  Storage(std::uint8_t *data, std::size_t bytes) : m_data(data), m_bytes(bytes) {}

private:
  std::uint8_t *m_data;
  std::size_t m_bytes;
  const Owner *m_owner = nullptr; ///< null: the memory belongs to the pool
  void *m_user = nullptr;
  PendingUse m_use;
  struct GiveBack {
    void operator()(DeferredClear *clear) const { DeferredClear::giveBack(clear); }
  };
  std::unique_ptr<DeferredClear, GiveBack> m_clear; ///< null: no clear was ever deferred
};

} // namespace arbiter::swrast
