#pragma once
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace arbiter {

/// Returns the candidate nearest to a misspelled word by edit distance (insertion, deletion,
/// replacement, a swap of neighbours), of equally near ones the first. Case is ignored. Returns an
/// empty text if more than a third of the longer word would have to change. Words over 64 bytes
/// match nothing, and candidates after the 256th are not looked at.
[[nodiscard]] std::string_view nearest(std::string_view word,
                                       std::span<const std::string_view> candidates);

/// Returns all candidates that are as near as the nearest, in their order.
[[nodiscard]] std::vector<std::string_view>
allNearest(std::string_view word, std::span<const std::string_view> candidates);

/// Returns "did you mean 'x'?", or the fallback.
[[nodiscard]] std::string didYouMean(std::string_view word,
                                     std::span<const std::string_view> candidates,
                                     std::string fallback = {});
[[nodiscard]] std::string didYouMean(std::string_view word,
                                     std::initializer_list<std::string_view> candidates,
                                     std::string fallback = {});

} // namespace arbiter
