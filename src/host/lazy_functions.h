#pragma once
#include <atomic>
#include <cstddef>

#include "host/null_host.h"

/// The host's lazy functions, beside HostTable's members: each is looked up when first called, so
/// that a thousand of them cost nothing to load.
namespace arbiter::host {

/// Function number `index`, once it is found; null before.
[[nodiscard]] inline void *lazyFunction(const HostTable &table, std::size_t index) {
  return __atomic_load_n(&table.lazy[index], __ATOMIC_RELAXED);
}

/// The names of the alias group, parted by NUL and ended by an empty one.
[[nodiscard]] const char *lazyNames(std::size_t index);

/// The first call of a lazy function through a table, and each call of one through a table that
/// finds none: the null context's, whose calls go to the next definition in the process.
class LazyCall {
public:
  LazyCall(const HostTable &table, std::size_t index);
  LazyCall(const LazyCall &) = delete;
  LazyCall &operator=(const LazyCall &) = delete;
  /// Null: there is none to be called.
  [[nodiscard]] void *function() const { return m_function ? m_function : m_null.function(); }

private:
  void *m_function = nullptr;
  NullCall m_null;
};

} // namespace arbiter::host
