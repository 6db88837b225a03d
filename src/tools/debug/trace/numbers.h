#pragma once
#include <array>
#include <cstdint>
#include <string>

namespace arbiter::tools::debug {

/// At most \p digits significant digits, without zeros behind: "0.25", "1.5e-09", "nan", "-inf".
[[nodiscard]] std::string numberText(float value, int digits = 6);
/// "(0.25, 1, -, -)": components outside the mask are a dash; one alone has no brackets.
[[nodiscard]] std::string vectorText(const std::array<float, 4> &value, std::uint8_t mask = 0xF,
                                     int digits = 6);
/// Clamped to [0,1] (NaN is 0), times 255, to the nearest.
[[nodiscard]] std::uint8_t byteOf(float value);
/// "xz": the components of a mask.
[[nodiscard]] std::string lettersOf(std::uint8_t mask);
/// A colour in 8 bits: "8c5a3fff".
[[nodiscard]] std::string colorText(const std::array<float, 4> &value);
/// "8c5a3fff"
[[nodiscard]] std::string hexColor(const std::array<std::uint8_t, 4> &bytes);

} // namespace arbiter::tools::debug
