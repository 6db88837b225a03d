#pragma once
#include <string_view>

namespace arbiter::fp {

/// Follows the counts in a warning about a limit that the program exceeds and loads with.
inline constexpr std::string_view kItLoads = ": it loads";

/// Returns the message of such a warning up to there: the card, its limit and the program's count.
[[nodiscard]] constexpr std::string_view exceededLimit(std::string_view message) {
  return message.substr(0, message.find(kItLoads));
}

} // namespace arbiter::fp
