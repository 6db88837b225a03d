#pragma once
#include <atomic>

#include "util/hud/hud_options.h"

/// Figures in each frame (ARBITER_HUD): version, host, frame times, draws by path, programs over
/// native limits.
namespace arbiter::state {
struct RasterContext;

namespace hud {

/// Tells whether a key is down. Null if the window system cannot say. Any thread may call it; it
/// does not wait.
inline constinit std::atomic<bool (*)(const HudKey &)> g_keyIsDown{nullptr};

/// Draws the figures into a corner of the frame that is about to be shown, unless they are hidden.
/// Leaves the application's objects and state unchanged. If the host shows the frame they are
/// blitted, which needs framebuffer objects and a window that is not multisampled.
void draw(RasterContext &context);

} // namespace hud
} // namespace arbiter::state
