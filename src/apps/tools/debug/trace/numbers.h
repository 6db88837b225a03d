#pragma once
#include <array>
#include <cstdint>
#include <string>

namespace arbiter::tools::debug {

/// Returns a number with at most \p digits significant digits and no trailing zeros: "0.25",
/// "1.5e-09", "nan", "-inf".
[[nodiscard]] std::string numberText(float value, int digits = 6);
/// Returns a vector as "(0.25, 1, -, -)". Components outside the mask are a dash; a single
/// component has no brackets.
[[nodiscard]] std::string vectorText(const std::array<float, 4> &value, std::uint8_t mask = 0xF,
                                     int digits = 6);
/// Clamps to [0,1] (NaN becomes 0), multiplies by 255 and rounds to the nearest.
[[nodiscard]] std::uint8_t byteOf(float value);
/// Returns the letters of a mask's components, such as "xz".
[[nodiscard]] std::string lettersOf(std::uint8_t mask);
/// Returns a color in 8 bits, such as "8c5a3fff".
[[nodiscard]] std::string colorText(const std::array<float, 4> &value);
/// Returns the hexadecimal digits of a color, such as "8c5a3fff".
[[nodiscard]] std::string hexColor(const std::array<std::uint8_t, 4> &bytes);

} // namespace arbiter::tools::debug
