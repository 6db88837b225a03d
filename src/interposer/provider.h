#pragma once
#include "host/host_table.h"
#include "util/cache/sealed.h"

namespace arbiter::interposer {

/// Looks up a host function by the host's own GetProcAddress. Ends the process if the result is one
/// of the layer's own entry points, as each call would return to itself.
using HostLookup = void *(*)(const char *name);

/// Returns the layer's answer to a lookup of `name`: its own entry point if the command is
/// intercepted and the host has it (or the layer provides it), else the host's pointer.
[[nodiscard]] void *resolveGl(const char *name, HostLookup host);

/// Ends the process if `function` is one of the layer's own.
void *checked(const char *name, void *function);

/// Fills the host's table through its GetProcAddress and seals it.
/// \param provider the name for the log
const host::HostTable &loadTable(Sealed<host::HostTable> &table, HostLookup host,
                                 const char *provider);

/// A function of the host's window-system interface.
template <typename Function> struct HostFunction {
  void *function = nullptr;
  template <typename... Arguments> auto operator()(Arguments... arguments) const {
    return reinterpret_cast<Function *>(function)(arguments...);
  }
};

/// A hook of a window-system interface: its name, the layer's function, and where the host's is
/// stored.
struct Hook {
  const char *name;
  void *function;
  void *const *host;
};

/// Fills in the host's functions, once, before any thread can call a hook and before their pages
/// are sealed.
void loadHooks(const Hook *begin, const Hook *end, HostLookup host);

/// Returns the hook of that name; null if there is none.
[[nodiscard]] const Hook *findHook(const Hook *begin, const Hook *end, const char *name);

} // namespace arbiter::interposer
