#pragma once
#include <cstddef>

/// Function tables that are filled at run time. They are read-only except during a write, so that a
/// stray write anywhere in the process cannot redirect a call.
namespace arbiter {

/// The size of a sealed page in bytes: the largest page size that kernels of this processor use.
#if defined(__x86_64__) || defined(__i386__)
inline constexpr std::size_t kSealedPage = 4096;
#else
inline constexpr std::size_t kSealedPage = 65536;
#endif

/// Makes whole pages read-only. If the system refuses, they stay writable.
void sealPages(const void *begin, std::size_t bytes);
/// True if the pages that begin there were sealed.
[[nodiscard]] bool isSealed(const void *begin);

/// Unseals pages for a write while other threads keep reading. Only one write per process is under
/// way at a time. A second one fails instead of waiting, as it may come from a signal handler that
/// interrupted the first.
class UnsealedPages {
public:
  UnsealedPages(const void *begin, std::size_t bytes);
  ~UnsealedPages();
  UnsealedPages(const UnsealedPages &) = delete;
  UnsealedPages &operator=(const UnsealedPages &) = delete;
  /// False if another write is under way, or the system refuses. Then nothing may be written.
  [[nodiscard]] explicit operator bool() const { return m_open; }

private:
  const void *const m_begin;
  const std::size_t m_bytes;
  bool m_open = false;
};

/// A value on pages of its own, for static storage.
template <typename T> class alignas(kSealedPage) Sealed {
public:
  [[nodiscard]] constexpr const T &operator*() const { return m_value; }
  [[nodiscard]] constexpr const T *operator->() const { return &m_value; }

  /// Calls write(T &) and seals the pages. Requires that no other thread reads them yet.
  template <typename Write> const T &fill(Write write) {
    write(m_value);
    sealPages(this, sizeof *this);
    return m_value;
  }
  /// Calls write(T &) on the unsealed pages; others may read what it stores at any moment.
  /// \returns false if write was not called
  template <typename Write> bool amend(Write write) {
    const UnsealedPages open(this, sizeof *this);
    if (!open)
      return false;
    write(m_value);
    return true;
  }

private:
  T m_value{};
};

} // namespace arbiter
