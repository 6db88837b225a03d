#pragma once

/// A context of OpenGL without a window system, current: Mesa's surfaceless platform, or the
/// display of the one device that there is. False where there is none.
[[nodiscard]] bool openContext();

/// The same of a context that announces the extension; says on stderr why there is none.
[[nodiscard]] bool openContextWith(const char *extension);
/// Draws go to a framebuffer object of so many pixels a side, RGBA8 with 24 bits of depth,
/// undithered.
void bindTarget(int size);
/// The status of a client that has nothing to test.
inline constexpr int kSkipped = 77;
