#pragma once
#include "host/host_table.h"

namespace arbiter::interposer {

/// A host function by name from the host's own GetProcAddress. Ends the process if the answer is
/// one of the layer's own entry points: each call would come back to itself.
using HostLookup = void *(*)(const char *name);

/// What the layer answers when `name` is asked for: its own entry point if the command is
/// intercepted and the host has it (or the layer provides it), else the host's pointer, untouched.
[[nodiscard]] void *resolveGl(const char *name, HostLookup host);

/// Ends the process if `function` is one of the layer's own.
void *checked(const char *name, void *function);

/// One hook of a window-system interface: our function under a name, the host's beside it.
struct Hook {
  const char *name;
  void *ours;
  void **host;
};

/// The hook of that name, with the host's function filled in; null if there is none, or the host
/// lacks it.
[[nodiscard]] void *resolveHook(const Hook *begin, const Hook *end, const char *name,
                                HostLookup host, bool &isHook);

} // namespace arbiter::interposer
