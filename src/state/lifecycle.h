#pragma once
#include <cstdint>

#include "state/current.h"

/// How the interposer drives contexts. It owns keys (provider, display, handle) and knows when the
/// host succeeded; the state tracker owns what a context is.
namespace arbiter::state {

enum class Provider : std::uint8_t { Glx, Egl, OsMesa };

/// A context in the share group of `share`, or in one of its own if `share` is null. Asks nothing
/// of the host: the host's context need not be current.
[[nodiscard]] Context *createContext(Provider provider, const host::HostTable *table,
                                     Context *share);

/// Makes `context` (null: the null context) the calling thread's, after the host's make-current
/// succeeded. The first time, asks the host for its limits and extensions.
void makeCurrent(Context *context);

/// The calling thread's context; null where it is the null context.
[[nodiscard]] Context *currentContext();

/// The application destroyed the context: it is freed now, or where it is current on some thread,
/// when it is last made un-current. A destroyed current context stays usable.
void destroyContext(Context *context);

/// glXCopyContext: the attribute groups of `mask` as far as the layer holds them, which is the
/// enable of fragment programs (ENABLE_BIT; the binding is in no group). `to` is current to no
/// thread.
void copyContext(const Context &from, Context &to, std::uint32_t mask);

/// About to present (SwapBuffers, or the like): counts a frame. Does not forward.
void frameEnd(Context *context);

} // namespace arbiter::state
