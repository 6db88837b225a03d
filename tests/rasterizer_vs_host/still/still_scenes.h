#pragma once
#include <vector>

/// Still pictures, each of one feature of the rasterizer, for still.cpp.
namespace software {

constexpr int kStillEdge = 96; ///< of the window, in pixels

/// A still picture, and how it is drawn.
struct StillScene {
  const char *name;
  void (*prepare)(); ///< called once, before the first frame; may be null
  /// Called in each frame, after a clear of the whole window, with a context's initial state
  void (*draw)();
};

[[nodiscard]] const std::vector<StillScene> &stillScenes();
/// Returns the part of stillScenes() about programs, images and framebuffers.
[[nodiscard]] const std::vector<StillScene> &otherStillScenes();

} // namespace software
