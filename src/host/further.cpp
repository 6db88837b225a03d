#include "host/further.h"

#include <array>
#include <cstring>
#include <iterator>

namespace arbiter::host {

namespace {

constexpr std::size_t kFurther = std::size(HostTable{}.further);

/// What follows in the process, for the null context.
constinit std::array<std::atomic<void *>, kFurther> g_next{};

void *find(const HostTable &table, std::size_t index) {
  const HostTable &host = table.instead ? *table.instead() : table;
  if (!host.lookup)
    return nullptr;
  void *function = further(host, index);
  for (const char *name = furtherNames(index); *name && !function; name += std::strlen(name) + 1)
    function = host.lookup(name);
  if (!function)
    function = detail::missingFunction();
  __atomic_store_n(&host.further[index], function, __ATOMIC_RELAXED);
  return function;
}

} // namespace

FurtherCall::FurtherCall(const HostTable &table, std::size_t index)
    : m_function(find(table, index)),
      m_null(m_function ? nullptr : furtherNames(index), g_next[index]) {}

} // namespace arbiter::host
