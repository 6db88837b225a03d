#include "interposer/provider.h"

#include <cstring>

#include "dispatch/entry_points.h"
#include "interposer/process.h"

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
  void *const theirs = host(name);
  return theirs && entry.function ? entry.function : theirs;
}

void *resolveHook(const Hook *begin, const Hook *end, const char *name, HostLookup host,
                  bool &isHook) {
  isHook = false;
  for (const Hook *hook = begin; hook != end; ++hook) {
    if (std::strcmp(hook->name, name) != 0)
      continue;
    isHook = true;
    if (!*hook->host)
      *hook->host = host(name);
    return *hook->host ? hook->ours : nullptr;
  }
  return nullptr;
}

} // namespace arbiter::interposer
