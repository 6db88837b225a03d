#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// The value of ARBITER_HUD: which figures of the layer each frame shows.
namespace arbiter {

enum class HudPart : std::uint8_t { Version, Host, Fps, Graph, Draws, Programs };
inline constexpr unsigned kHudParts = 6;

/// A key with the modifiers that are held with it.
struct HudKey {
  std::uint32_t keysym = 0; ///< of X11; 0: none
  bool shift = false, control = false, alt = false;

  bool operator==(const HudKey &) const = default;
};

struct HudOptions {
  bool on = false;
  bool hidden = false; ///< until the key is pressed
  bool right = false;  ///< in a right corner, else a left one
  bool bottom = false; ///< in a lower corner, else an upper one
  int scale = 0;       ///< pixels of the frame a pixel of a letter; 0: by the frame's height
  HudKey key = {.keysym = 0xFFC6, .shift = true}; ///< Shift and F9
  std::uint8_t parts = (1u << kHudParts) - 1;     ///< one bit a HudPart

  [[nodiscard]] bool has(HudPart part) const { return (parts >> unsigned(part) & 1u) != 0; }
  bool operator==(const HudOptions &) const = default;
};

/// Reads the value of ARBITER_HUD: 0 or nothing, 1, or words separated by commas. Parts that are
/// named are the only ones; without a part there are all.
/// \param wrong says what was expected where there is no result
[[nodiscard]] std::optional<HudOptions> parseHudOptions(std::string_view value, std::string &wrong);

} // namespace arbiter
