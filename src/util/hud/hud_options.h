#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Parses ARBITER_HUD, which selects the values of the layer that each frame shows.
namespace arbiter {

enum class HudPart : std::uint8_t { Version, Host, Fps, Graph, Draws, Programs };
inline constexpr unsigned kHudParts = 6;

/// A key and the modifiers held with it.
struct HudKey {
  std::uint32_t keysym = 0; ///< of X11; 0: none
  bool shift = false, control = false, alt = false;

  bool operator==(const HudKey &) const = default;
};

struct HudOptions {
  bool on = false;
  bool hidden = false; ///< hidden until the key is pressed
  bool right = false;  ///< in a right corner, else a left one
  bool bottom = false; ///< in a lower corner, else an upper one
  int scale = 0;       ///< frame pixels for each pixel of a letter; 0: chosen by the frame's height
  HudKey key = {.keysym = 0xFFC6, .shift = true}; ///< Shift and F9
  std::uint8_t parts = (1u << kHudParts) - 1;     ///< one bit for each HudPart

  [[nodiscard]] bool has(HudPart part) const { return (parts >> unsigned(part) & 1u) != 0; }
  bool operator==(const HudOptions &) const = default;
};

/// Parses the value of ARBITER_HUD: 0 or nothing, 1, or words separated by commas. If any parts are
/// named, only those are shown.
/// \param wrong set to what was expected if there is no result
[[nodiscard]] std::optional<HudOptions> parseHudOptions(std::string_view value, std::string &wrong);

} // namespace arbiter
