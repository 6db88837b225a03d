#pragma once
#include <exception>

#include "state/lifecycle/lifecycle.h"
#include "util/own_exception.h"

/// Maps host handles to the state tracker's contexts. Only create, destroy and make-current take
/// the lock; no GL command comes here.
namespace arbiter::interposer::registry {

using state::Provider;

/// Identifies a context as the application names it. `display` is null for OSMesa.
struct Key {
  Provider provider;
  const void *display;
  const void *handle;
};

/// Called when the host has made a context. If the key is in use, its context was destroyed unseen
/// and is replaced.
/// \param indirect true if the X server draws for the context
/// \return false if there is no memory; the context is then unknown here, and the host's must be
/// destroyed
[[nodiscard]] bool created(const Key &key, const host::HostTable &table, const void *shareHandle,
                           bool indirect = false);

/// Called before the host destroys a context. It frees the key; the context lives on while it is
/// current. After the host's call another thread could meet the handle in its next life.
void destroyed(const Key &key);

/// Called when the host has made the context current on this thread; adopts one that was never seen
/// before. A null handle unbinds the current context if it belongs to the provider.
/// \param drawable null: unknown
/// \return false if there is no memory; the layer then has no current context, and the host's must
/// be unbound too
[[nodiscard]] bool madeCurrent(const Key &key, const host::HostTable &table,
                               const state::Drawable *drawable = nullptr);

/// Called when the host has copied attribute groups from one context to another of the same
/// display.
void copied(const Key &from, const Key &to, unsigned long mask);

/// Called when a display is gone; destroys all its contexts.
void displayClosed(Provider provider, const void *display);

/// Wraps a function of the window system that applications call: if the layer runs out of memory it
/// returns a zero result. It is not noexcept, as a thread that is cancelled while the host waits
/// for the X server is unwound through it.
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
