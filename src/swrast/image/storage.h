#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>

#include "swrast/image/deferred_clear.h"

/// The memory of images, and the pool of what was freed.
namespace arbiter::swrast {

/// Draws that wait to be done.
class PendingDraws {
public:
  /// All are done when it returns.
  virtual void finish() = 0;
  /// Other threads begin with them, where there are any.
  virtual void post() = 0;

protected:
  ~PendingDraws() = default;
};

/// Which draws wait that read or write what lies in a storage.
struct PendingUse {
  PendingDraws *draws = nullptr; ///< null: none
  std::uint32_t batch = 0;       ///< the last one that does
  bool isDrawnTo = false;        ///< by that batch
  bool isSampled = false;        ///< likewise
};

/// A block of memory that images share. 64 bytes before and behind may be read. Freed blocks go to
/// a small pool, so that ping-pong between two buffers allocates nothing.
class Storage {
public:
  /// Null if there is no memory, or storages hold what they may. The bytes are undefined.
  [[nodiscard]] static std::shared_ptr<Storage> make(std::uint64_t bytes);
  /// Whose memory images use that no Storage allocated.
  struct Owner {
    void (*release)(void *user); ///< the last image lets go
    /// Whether a reader other than the images has still to read what was written: until then it may
    /// not be written again. \param wait until he has
    bool (*isRead)(void *user, bool wait);
  };
  /// On failure the owner's release() is called at once. 64 bytes before and after may be read of
  /// it too.
  [[nodiscard]] static std::shared_ptr<Storage> wrap(std::uint8_t *data, std::size_t bytes,
                                                     const Owner &owner, void *user);
  ~Storage();
  Storage(const Storage &) = delete;
  Storage &operator=(const Storage &) = delete;
  [[nodiscard]] std::uint8_t *data() const { return m_data; } ///< aligned to 64 bytes
  [[nodiscard]] std::size_t bytes() const { return m_bytes; }
  /// Whether a reader other than the images still reads it; false without an owner.
  [[nodiscard]] bool isRead() const { return m_owner && m_owner->isRead(m_user, false); }
  /// Until it may be written again.
  void awaitReader() const {
    if (m_owner)
      (void)m_owner->isRead(m_user, true);
  }
  /// Before what lies here is read or written by anyone but draws that wait, or freed.
  void settle() const {
    if (m_use.draws) [[unlikely]]
      m_use.draws->finish();
  }
  [[nodiscard]] PendingUse &pendingUse() { return m_use; }
  /// The clear of what lies here that is still to be written, in part; null: none. Draws that wait
  /// may write it.
  [[nodiscard]] DeferredClear *pendingClear() const {
    return m_clear && m_clear->isPending() ? m_clear.get() : nullptr;
  }
  /// Clears without writing. False if there is no memory for it.
  [[nodiscard]] bool deferClear(const ClearedPixels &pixels, const ClearPattern &pattern);
  /// All that lies here is about to be replaced.
  void forgetClear() {
    settle();
    if (m_clear)
      m_clear->forget();
  }
  /// Memory that all storages hold now, pool included.
  [[nodiscard]] static std::size_t totalBytes();
  /// How much all may hold, pool included. In processes of 32 bits it is an eighth of the addresses
  /// there are: what the application and the host's driver cannot map ends the application.
  static constexpr std::uint64_t kMostBytes = std::uint64_t(1) << (sizeof(void *) == 4 ? 29 : 46);
  /// For tests. \returns what it was
  static std::uint64_t limitTotal(std::uint64_t bytes);

protected:
  Storage(std::uint8_t *data, std::size_t bytes) : m_data(data), m_bytes(bytes) {}

private:
  std::uint8_t *m_data;
  std::size_t m_bytes;
  const Owner *m_owner = nullptr; ///< null: the pool's memory
  void *m_user = nullptr;
  PendingUse m_use;
  struct GiveBack {
    void operator()(DeferredClear *clear) const { DeferredClear::giveBack(clear); }
  };
  std::unique_ptr<DeferredClear, GiveBack> m_clear; ///< null: never deferred
};

} // namespace arbiter::swrast
