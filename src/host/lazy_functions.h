#pragma once
#include <atomic>
#include <cstddef>

#include "host/null_host.h"

/// The host's lazy functions, beside HostTable's members. Each is looked up at its first call, so
/// that loading a thousand of them costs nothing.
namespace arbiter::host {

/// Returns lazy function number `index`, or null until it is found.
[[nodiscard]] inline void *lazyFunction(const HostTable &table, std::size_t index) {
  return __atomic_load_n(&table.lazy[index], __ATOMIC_RELAXED);
}

/// Returns the names of the alias group. A NUL ends each name, and an empty name ends the list.
[[nodiscard]] const char *lazyNames(std::size_t index);

/// The first call of a lazy function through a table. The null context's table never keeps a
/// function, so that each of its calls comes here and goes to the next definition in the process.
class LazyCall {
public:
  LazyCall(const HostTable &table, std::size_t index);
  LazyCall(const LazyCall &) = delete;
  LazyCall &operator=(const LazyCall &) = delete;
  /// Returns the function to call, or null if there is none.
  [[nodiscard]] void *function() const { return m_function ? m_function : m_null.function(); }

private:
  void *m_function = nullptr;
  NullCall m_null;
};

} // namespace arbiter::host
