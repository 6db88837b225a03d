#include "host/lazy_functions.h"

#include <cstring>
#include <iterator>

#include "util/cache/sealed.h"

namespace arbiter::host {

namespace {

/// Stores a lazy function in its table. A sealed table that cannot be written now looks the
/// function up again at the next call. The constant null table looks nothing up and is never passed
/// here.
void keep(const HostTable &host, std::size_t index, void *function) {
  if (!isSealed(&host))
    return __atomic_store_n(&host.lazy[index], function, __ATOMIC_RELAXED);
  if (const UnsealedPages open(&host, sizeof host); open)
    __atomic_store_n(&host.lazy[index], function, __ATOMIC_RELAXED);
}

void *find(const HostTable &table, std::size_t index) {
  const HostTable &host = table.instead ? *table.instead() : table;
  if (!host.lookup)
    return nullptr;
  // Another table may have found it already: while a primitive is recorded, one stands in for the
  // host's.
  if (void *const function = lazyFunction(host, index))
    return function;
  void *function = nullptr;
  for (const char *name = lazyNames(index); *name && !function; name += std::strlen(name) + 1)
    function = host.lookup(name);
  if (!function)
    function = detail::missingFunction();
  keep(host, index, function);
  return function;
}

} // namespace

LazyCall::LazyCall(const HostTable &table, std::size_t index)
    : m_function(find(table, index)),
      m_null(m_function ? nullptr : lazyNames(index), kFunctions + index) {}

} // namespace arbiter::host
