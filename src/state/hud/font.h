#pragma once
#include <cstdint>

/// Letters for figures in the frame: capitals, digits and a few signs, five pixels by seven.
namespace arbiter::state::hud {

inline constexpr int kGlyphWidth = 5, kGlyphHeight = 7;

/// A row of the letter's pixels, the top row is 0: bit 4 is the left one. Small letters are drawn
/// as capitals, what there is no letter for as nothing.
[[nodiscard]] std::uint8_t glyphRow(char letter, int row);

} // namespace arbiter::state::hud
