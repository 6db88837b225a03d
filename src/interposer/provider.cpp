#include "interposer/provider.h"

#include <algorithm>
#include <cstring>

#include "dispatch/entry_points.h"
#include "interposer/process.h"
#include "state/programs/offered_aliases.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::interposer {

void *checked(const char *name, void *function) {
  if (dispatch::isOurs(function))
    fatal("the host's %s leads back to Arbiter: is the host vendor Arbiter itself? "
          "(ARBITER_HOST_VENDOR)",
          name);
  return function;
}

void *resolveGl(const char *name, HostLookup host) {
  const dispatch::EntryPoint entry = dispatch::find(name);
  if (entry.function && entry.provided)
    return entry.function;
  void *const hosts = host(name);
  if (!hosts)
    return nullptr;
  const dispatch::EntryPoint found = entry.function ? entry : dispatch::findForSoftware(name);
  const bool serves = !found.forSoftware || settings().backend != Backend::Host ||
                      (found.forAliases && state::attributesMayAlias());
  return found.function && serves ? found.function : hosts;
}

const host::HostTable &loadTable(Sealed<host::HostTable> &table, HostLookup host,
                                 const char *provider) {
  return table.fill([&](host::HostTable &made) {
    const std::size_t found = host::loadHostTable(made, host);
    logDebug("layer", "%s: the host has %zu of the functions asked for", provider, found);
  });
}

void loadHooks(const Hook *begin, const Hook *end, HostLookup host) {
  for (const Hook *hook = begin; hook != end; ++hook)
    *const_cast<void **>(hook->host) = host(hook->name);
}

const Hook *findHook(const Hook *begin, const Hook *end, const char *name) {
  const Hook *const hook =
      std::find_if(begin, end, [&](const Hook &h) { return std::strcmp(h.name, name) == 0; });
  return hook == end ? nullptr : hook;
}

} // namespace arbiter::interposer
