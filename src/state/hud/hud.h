#pragma once

/// Figures in each frame (ARBITER_HUD): frame time, draws by path, programs over native limits.
namespace arbiter::state {
class Context;

namespace hud {

/// Writes the figures into the lower left corner of the frame that is about to be shown. The
/// application's objects are not touched, and its state is as before. Frames that the host shows
/// are written to by a blit: not where the window is multisampled, or the host has no framebuffer
/// objects.
void draw(Context &context);

} // namespace hud
} // namespace arbiter::state
