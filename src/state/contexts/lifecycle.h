#pragma once
#include <cstdint>

#include "state/core/context_hot.h"
#include "state/core/provider.h"

/// How the interposer drives contexts. It owns keys (provider, display, handle) and knows when the
/// host succeeded; the state tracker owns what a context is.
namespace arbiter::state {

namespace software {
struct Drawable;
}

/// A context in the share group of `share`, or in one of its own if `share` is null. Asks nothing
/// of the host: the host's context need not be current.
/// \param indirect the X server draws what the context is told
[[nodiscard]] Context *createContext(Provider provider, const host::HostTable *table,
                                     Context *share, bool indirect = false);

/// Makes `context` (null: the null context) the calling thread's, after the host's make-current
/// succeeded. The first time, asks the host for its limits and extensions.
/// \param drawable what it draws to where no framebuffer object is bound; null: unknown
void makeCurrent(Context *context, const software::Drawable *drawable = nullptr);

/// Before the host takes the calling thread's context away, or gives it another drawable: it gets
/// the pixels that we hold. The context stays usable, should the host refuse.
void leaveCurrent();

/// The calling thread's context; null where it is the null context.
[[nodiscard]] Context *currentContext();
/// The null context, of threads without one.
[[nodiscard]] Context &nullContext();

/// The application destroyed the context: it is freed now, or where it is current on some thread,
/// when it is last made un-current. A destroyed current context stays usable.
void destroyContext(Context *context);

/// glXCopyContext: the attribute groups of `mask` as far as the layer holds them, which is the
/// enable of fragment programs (ENABLE_BIT; the binding is in no group). `to` is current to no
/// thread.
void copyContext(const Context &from, Context &to, std::uint32_t mask);

/// What the window system is about to do with the calling thread's context and its pixels.
enum class Exchange : std::uint8_t {
  Present, ///< the drawable's back buffer is shown, and undefined then
  Flush,   ///< others may look at what they can see of it: glXWaitGL, eglWaitClient
  Read,    ///< its pixels are read
  Change,  ///< its images are read, or replaced: a pixmap becomes a texture, a texture an image
};
/// Brings the host as far up to date as that needs, where it is not. True of Present: what the
/// application sees is shown already, and the host has nothing to swap.
bool exchange(Exchange what, const char *name);
/// Before the window system has the host compile display lists of the current context past the
/// layer (glXUseXFont): what the names [first, first + count) held is gone, and they are the
/// host's. Nothing where no context of the layer's is current.
void hostDefinesLists(std::uint32_t first, std::int32_t count);

/// The host is about to swap the current drawable's buffers by itself, and all pixels went to it.
void hostSwaps();

/// About to present (SwapBuffers, or the like): counts a frame. Does not forward.
void frameEnd(Context *context);

} // namespace arbiter::state
