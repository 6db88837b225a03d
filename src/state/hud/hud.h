#pragma once
#include <atomic>

#include "util/hud/hud_options.h"

/// Figures in each frame (ARBITER_HUD): version, host, times of frames, draws by path, programs
/// over native limits.
namespace arbiter::state {
class Context;

namespace hud {

/// Whether a key is down, as the window system says; null: nobody knows. Any thread may call it;
/// it does not wait.
inline constinit std::atomic<bool (*)(const HudKey &)> g_keyIsDown{nullptr};

/// Writes the figures into a corner of the frame that is about to be shown, unless they are hidden.
/// The application's objects are not touched, and its state is as before. Frames that the host
/// shows are written to by a blit: not where the window is multisampled, or the host has no
/// framebuffer objects.
void draw(Context &context);

} // namespace hud
} // namespace arbiter::state
