#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "state/control/host_pixels.h"
#include "util/hud/hud_options.h"

namespace arbiter::state::hud {

/// The figures of a frame.
struct Figures {
  std::string version;      ///< of the layer, and its profile
  std::string host;         ///< the renderer that the host names
  std::vector<float> times; ///< ms, of the last frames, the newest last
  struct Draws {
    const char *path;
    std::uint64_t count;
  };
  std::vector<Draws> draws; ///< of this frame
  std::size_t programs = 0, overNative = 0;
  std::uint64_t refused = 0; ///< texts that the profile alone refuses
};

/// "Arbiter 1.0  profile r300, ATI Radeon 9700": the layer's version and the profile's own name,
/// whatever the user called it, with the card.
/// \param description the profile's, which begins with the card where its chip stands in brackets
[[nodiscard]] std::string versionLine(std::string_view profile, std::string_view description);
/// The lines of the parts that are asked for.
[[nodiscard]] std::vector<std::string> linesOf(const Figures &figures, const HudOptions &options);
/// Pixels of the frame that a pixel of a letter is wide: letters stay readable in a frame of that
/// height.
[[nodiscard]] int scaleOf(const HudOptions &options, int frameHeight);
/// Draws lines light on dark, and below them a bar a frame's time; bottom row first.
/// \param times ms; empty: no bars \param scale pixels that a pixel of a letter is wide
[[nodiscard]] remote::Picture pictureOf(const std::vector<std::string> &lines,
                                        const std::vector<float> &times, int scale);

} // namespace arbiter::state::hud
