#pragma once
#include <cstdint>
#include <string_view>

namespace arbiter::fp {

/// A decimal <integer>; UINT32_MAX for every value from there on, which exceeds each limit.
[[nodiscard]] std::uint32_t parseInteger(std::string_view digits);

/// What a numeral comes to as a float.
struct FloatValue {
  float value = 0;
  bool overflow = false; ///< beyond the largest finite float, which `value` then is
};

/// The nearest float to a <floatConstant> or <integer>, whatever the locale. Too small is zero.
[[nodiscard]] FloatValue parseFloat(std::string_view numeral);

} // namespace arbiter::fp
