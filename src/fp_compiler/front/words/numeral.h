#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace arbiter::fp {

/// Parses a decimal <integer>. Returns UINT32_MAX for any larger value, which exceeds every limit.
[[nodiscard]] std::uint32_t parseInteger(std::string_view digits);

/// Returns the number after \p letters: 12 for "R12". Returns nothing for any other word, such as
/// "R012", and for more than \p maxDigits digits.
[[nodiscard]] std::optional<std::uint32_t>
numberBehind(std::string_view word, std::string_view letters, std::size_t maxDigits = 6);

/// The value of a numeral as a float.
struct FloatValue {
  float value = 0;
  bool overflow = false; ///< beyond the largest finite float, which `value` then is
};

/// Returns the nearest float to a <floatConstant> or <integer>, whatever the locale. A number that
/// is too small gives zero.
[[nodiscard]] FloatValue parseFloat(std::string_view numeral);

} // namespace arbiter::fp
