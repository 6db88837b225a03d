#pragma once

/// A context of OpenGL without a window system, current: Mesa's surfaceless platform, or the
/// display of the one device that there is. False where there is none.
[[nodiscard]] bool openContext();
