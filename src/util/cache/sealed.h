#pragma once
#include <cstddef>

/// Tables of functions that are filled at run time: read-only but for the moment of a write, so
/// that a stray write of whatever part of the process cannot make a call lead elsewhere.
namespace arbiter {

/// Of memory that is sealed, in bytes: the largest page that kernels of this processor use.
#if defined(__x86_64__) || defined(__i386__)
inline constexpr std::size_t kSealedPage = 4096;
#else
inline constexpr std::size_t kSealedPage = 65536;
#endif

/// Makes whole pages read-only. Where the system refuses, they stay as they are.
void sealPages(const void *begin, std::size_t bytes);
/// Whether pages that begin there were sealed.
[[nodiscard]] bool isSealed(const void *begin);

/// Sealed pages while they are written again. Reading goes on in other threads. One write of the
/// process's is under way at a time; nothing waits, as a signal's handler may have interrupted it.
class UnsealedPages {
public:
  UnsealedPages(const void *begin, std::size_t bytes);
  ~UnsealedPages();
  UnsealedPages(const UnsealedPages &) = delete;
  UnsealedPages &operator=(const UnsealedPages &) = delete;
  /// False: another write is under way, or the system refuses. Nothing may be written.
  [[nodiscard]] explicit operator bool() const { return m_open; }

private:
  const void *const m_begin;
  const std::size_t m_bytes;
  bool m_open = false;
};

/// A value with pages of its own, for static storage.
template <typename T> class alignas(kSealedPage) Sealed {
public:
  [[nodiscard]] constexpr const T &operator*() const { return m_value; }
  [[nodiscard]] constexpr const T *operator->() const { return &m_value; }

  /// Once, before others read it: calls write(T &) and seals.
  template <typename Write> const T &fill(Write write) {
    write(m_value);
    sealPages(this, sizeof *this);
    return m_value;
  }
  /// Later: calls write(T &), which stores what others may read at that moment. False: not called.
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
