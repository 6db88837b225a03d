#pragma once
#include <cstdint>

#include "state/core/context_hot.h"
#include "state/core/provider.h"

/// The interposer's interface to contexts. The interposer keeps the handles (provider, display,
/// context) and knows when the host succeeded; the state tracker keeps the contexts.
namespace arbiter::state {

class Context;
struct Drawable;

/// Makes a context in the share group of `share`, or in a new group if `share` is null. Calls
/// nothing of the host, whose context need not be current.
/// \param indirect the X server draws (indirect rendering)
[[nodiscard]] Context *createContext(Provider provider, const host::HostTable *table,
                                     Context *share, bool indirect = false);

/// Makes `context` the calling thread's (null: the null context), after the host's make-current
/// succeeded. The first time it queries the host's limits and extensions.
/// \param drawable the default framebuffer; null: unknown
void makeCurrent(Context *context, const Drawable *drawable = nullptr);

/// Gives the host all pixels that the layer holds. Called before the host takes the context from
/// the calling thread, or gives it another drawable. The context stays usable if the host refuses.
void leaveCurrent();

/// Returns the calling thread's context; null if it is the null context.
[[nodiscard]] Context *currentContext();
/// Returns the null context, which threads without a context have.
[[nodiscard]] Context &nullContext();

/// Frees a context that the application destroyed. If it is current on some thread it stays usable
/// until it is last made un-current, and is freed then.
void destroyContext(Context *context);

/// glXCopyContext: copies the layer's part of the attribute groups in `mask`. That is the enable of
/// fragment programs in ENABLE_BIT; their binding is in no group. `to` is not current on any
/// thread.
void copyContext(const Context &from, Context &to, std::uint32_t mask);

/// Ways in which the window system uses the pixels of the calling thread's context.
enum class Exchange : std::uint8_t {
  Present, ///< shows the back buffer, which is undefined afterwards
  Flush,   ///< lets others see what has been drawn: glXWaitGL, eglWaitClient
  Read,    ///< reads its pixels
  Change,  ///< reads or replaces its images: a pixmap becomes a texture, a texture an image
};
/// Updates the host as far as `what` requires. Returns true, for Present only, if the layer has
/// shown the frame itself and the host has nothing to swap.
bool exchange(Exchange what, const char *name);
/// Forgets the lists [first, first + count). Called before the window system compiles display lists
/// on the host without the layer (glXUseXFont); the names are the host's from then on. Does nothing
/// without a current context of the layer's.
void hostDefinesLists(std::uint32_t first, std::int32_t count);

/// Notes that the host is about to swap the current drawable's buffers. It has all pixels.
void hostSwaps();

/// Counts a frame, when it is about to be presented (SwapBuffers and the like). Does not forward.
void frameEnd(Context *context);

} // namespace arbiter::state
