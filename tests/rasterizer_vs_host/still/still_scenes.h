#pragma once
#include <vector>

/// Still pictures, each of one feature of the rasterizer, for still.cpp.
namespace software {

constexpr int kStillEdge = 96; ///< of the window, in pixels

/// A still picture, and how it is drawn.
struct StillScene {
  const char *name;
  void (*prepare)(); ///< once, before the first frame; may be null
  void (*draw)();    ///< each frame, behind a clear of all of it, with state as a context begins
};

[[nodiscard]] const std::vector<StillScene> &stillScenes();
/// The part of stillScenes() that is about programs, images and framebuffers.
[[nodiscard]] const std::vector<StillScene> &otherStillScenes();

} // namespace software
