#pragma once
#include <string>
#include <vector>

#include "state/control/host_pixels.h"
#include "state/control/tallies.h"

namespace arbiter::state::hud {

/// What is said of a frame.
struct Figures {
  double last = 0, mean = 0, worst = 0; ///< ms, of the last frames
  struct Draws {
    const char *path;
    std::uint64_t count;
  };
  std::vector<Draws> draws; ///< of this frame
  std::size_t programs = 0, overNative = 0;
  std::uint64_t refused = 0; ///< texts that the profile alone refuses
};

[[nodiscard]] std::vector<std::string> linesOf(const Figures &figures);
/// The lines, light on dark, each pixel of a letter `scale` pixels wide; bottom row first.
[[nodiscard]] remote::Picture pictureOf(const std::vector<std::string> &lines, int scale);

} // namespace arbiter::state::hud
