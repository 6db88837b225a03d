#pragma once
#include <exception>

#include "state/contexts/lifecycle.h"
#include "util/own_exception.h"

/// Which of the state tracker's contexts a host's handle stands for. Locked in create, destroy and
/// make-current only; no GL command comes here.
namespace arbiter::interposer::registry {

using state::Provider;

/// A context as the application names it. `display` is null for OSMesa.
struct Key {
  Provider provider;
  const void *display;
  const void *handle;
};

/// The host made a context. A key in use by a context that was never seen destroyed is taken over.
/// \param indirect the X server draws what the context is told
/// \return false if there is no memory: then it is not known here, and the host's must go
[[nodiscard]] bool created(const Key &key, const host::HostTable &table, const void *shareHandle,
                           bool indirect = false);

/// The host destroyed a context: the key is free again, the context lives on while it is current.
/// Call before the host does, or another thread may meet the handle in its next life.
void destroyed(const Key &key);

/// The host made the context current on this thread; one never seen before is adopted. A null
/// handle un-binds, if what is current is the provider's own.
/// \param drawable null: unknown
/// \return false if there is no memory: then no context of the layer's is current, and the host's
/// must be
///         un-bound too
[[nodiscard]] bool madeCurrent(const Key &key, const host::HostTable &table,
                               const state::software::Drawable *drawable = nullptr);

/// The host copied attribute groups from one context to another of the same display.
void copied(const Key &from, const Key &to, unsigned long mask);

/// A display is gone: all its contexts are destroyed.
void displayClosed(Provider provider, const void *display);

/// A function of the window system as the application calls it: where there is no memory for what
/// the layer does it returns a zero of its result. Not noexcept: a thread that is cancelled while
/// the host waits for the X server is unwound through this.
template <auto Function> struct Guarded;
template <typename Result, typename... Arguments, Result (*Function)(Arguments...)>
struct Guarded<Function> {
  static Result call(Arguments... arguments) {
    try {
      return Function(arguments...);
    } catch (const std::exception &error) {
      passOn(error);
      return Result();
    }
  }
};

/// True if a context of the provider is current on this thread.
[[nodiscard]] bool isCurrent(Provider provider);

} // namespace arbiter::interposer::registry
