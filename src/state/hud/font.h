#pragma once
#include <cstdint>

/// The font of the figures: capitals, digits and a few signs, 5x7 pixels.
namespace arbiter::state::hud {

inline constexpr int kGlyphWidth = 5, kGlyphHeight = 7;

/// Returns a row of a letter's pixels. Row 0 is the top, bit 4 the left pixel. Small letters become
/// capitals, and unknown characters are blank.
[[nodiscard]] std::uint8_t glyphRow(char letter, int row);

} // namespace arbiter::state::hud
