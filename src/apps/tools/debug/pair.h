#pragma once
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

namespace arbiter::tools::debug {

/// Parses "X,Y", two numbers and nothing else, as in options for pixels and ranges. Returns nothing
/// for other texts, and for numbers out of range.
template <typename Number>
[[nodiscard]] std::optional<std::pair<Number, Number>> parsePair(std::string_view text) {
  std::pair<Number, Number> pair;
  const char *const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, pair.first);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != ',')
    return {};
  const auto second = std::from_chars(first.ptr + 1, end, pair.second);
  if (second.ec != std::errc() || second.ptr != end)
    return {};
  return pair;
}

} // namespace arbiter::tools::debug
