#include "util/suggest.h"

#include <algorithm>
#include <array>

#include "util/text/letters.h"

namespace arbiter {

namespace {

constexpr std::size_t kMaxWord = 64;
constexpr std::size_t kMaxCandidates = 256; // more would let the cost grow with a program

/// Returns the optimal string alignment distance, ignoring case. It needs only three rows. Returns
/// `enough` for any distance from there on.
unsigned distance(std::string_view a, std::string_view b, unsigned enough) {
  using Row = std::array<unsigned, kMaxWord + 1>;
  Row rows[3];
  for (std::size_t j = 0; j <= b.size(); ++j)
    rows[0][j] = unsigned(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    Row &row = rows[i % 3];
    const Row &above = rows[(i + 2) % 3];
    const Row &twoAbove = rows[(i + 1) % 3];
    row[0] = unsigned(i);
    unsigned least = row[0];
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lowerCase(a[i - 1]) == lowerCase(b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0u : 1u)});
      if (i > 1 && j > 1 && lowerCase(a[i - 1]) == lowerCase(b[j - 2]) &&
          lowerCase(a[i - 2]) == lowerCase(b[j - 1]))
        row[j] = std::min(row[j], twoAbove[j - 2] + 1);
      least = std::min(least, row[j]);
    }
    // A swap skips one row at a cost of one.
    if (least > enough)
      return enough;
  }
  return std::min(rows[a.size() % 3][b.size()], enough);
}

} // namespace

std::vector<std::string_view> allNearest(std::string_view word,
                                         std::span<const std::string_view> candidates) {
  std::vector<std::string_view> found;
  if (word.empty() || word.size() > kMaxWord)
    return found;
  std::size_t best = kMaxWord;
  for (const std::string_view candidate :
       candidates.first(std::min(candidates.size(), kMaxCandidates))) {
    const auto [shorter, longer] = std::minmax({word.size(), candidate.size()});
    const std::size_t allowed = std::min(best, longer / 3);
    if (longer > kMaxWord || longer - shorter > allowed)
      continue;
    const std::size_t changes = distance(word, candidate, unsigned(allowed) + 1);
    if (changes > allowed)
      continue;
    if (changes < best)
      found.clear();
    best = changes;
    found.push_back(candidate);
  }
  return found;
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates) {
  const std::vector<std::string_view> found = allNearest(word, candidates);
  return found.empty() ? std::string_view() : found.front();
}

std::string didYouMean(std::string_view word, std::span<const std::string_view> candidates,
                       std::string fallback) {
  const std::string_view found = nearest(word, candidates);
  if (found.empty())
    return fallback;
  return "did you mean '" + std::string(found) + "'?";
}

std::string didYouMean(std::string_view word, std::initializer_list<std::string_view> candidates,
                       std::string fallback) {
  return didYouMean(word, std::span(candidates.begin(), candidates.size()), std::move(fallback));
}

} // namespace arbiter
