#pragma once
#include <span>
#include <string_view>

namespace arbiter {

/// Returns the known name nearest to a mistyped one by edit distance (insertion, deletion,
/// replacement, exchange of neighbours), for "did you mean". Returns "" if more than a third of the
/// longer name would have to change. Names over 64 bytes never match.
[[nodiscard]] std::string_view closest(std::string_view typed,
                                       std::span<const std::string_view> known);

} // namespace arbiter
