#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "state/control/host_pixels.h"
#include "util/hud/hud_options.h"

namespace arbiter::state::hud {

struct Figures {
  std::string version;      ///< of the layer, with its profile
  std::string host;         ///< GL_RENDERER
  std::vector<float> times; ///< ms per frame, the newest last
  struct Draws {
    const char *path;
    std::uint64_t count;
  };
  std::vector<Draws> draws; ///< in this frame
  std::size_t programs = 0, overNative = 0;
  std::uint64_t refused = 0; ///< texts that only the profile refuses
};

/// Returns "Arbiter 1.0  profile r300, ATI Radeon 9700": the layer's version, the profile's own
/// name, and its card.
/// \param description the profile's; the card's name comes before the chip in brackets
[[nodiscard]] std::string versionLine(std::string_view profile, std::string_view description);
/// Returns the lines of the requested parts.
[[nodiscard]] std::vector<std::string> linesOf(const Figures &figures, const HudOptions &options);
/// Returns how many pixels wide a letter's pixel is, so that letters stay readable in a frame of
/// that size, and usual lines fit into its width.
[[nodiscard]] int scaleOf(const HudOptions &options, int frameWidth, int frameHeight);
/// Returns the options with as many parts as leave a small frame visible: they take an eighth of
/// its height, or one line. If the user chose parts or a scale, all
/// parts stay.
[[nodiscard]] HudOptions fitted(HudOptions options, int frameHeight);
/// Draws lines, light on dark, above a graph of frame times; bottom row first.
/// \param times ms; empty: no graph
/// \param scale the width of a letter's pixel
[[nodiscard]] control::Picture pictureOf(const std::vector<std::string> &lines,
                                         const std::vector<float> &times, int scale);

} // namespace arbiter::state::hud
