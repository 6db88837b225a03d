#include "util/suggest.h"

#include <algorithm>
#include <array>

namespace arbiter {

namespace {

constexpr std::size_t kMaxName = 64;

std::size_t distance(std::string_view a, std::string_view b) {
  std::array<std::array<std::size_t, kMaxName + 1>, 3> rows = {};
  for (std::size_t j = 0; j <= b.size(); ++j)
    rows[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto &row = rows[i % 3];
    const auto &above = rows[(i + 2) % 3];
    const auto &twoAbove = rows[(i + 1) % 3];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, above[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], twoAbove[j - 2] + 1);
    }
  }
  return rows[a.size() % 3][b.size()];
}

} // namespace

std::string_view closest(std::string_view typed, std::span<const std::string_view> known) {
  std::string_view best;
  std::size_t bestDistance = kMaxName;
  for (const std::string_view name : known) {
    if (typed.empty() || typed.size() > kMaxName || name.size() > kMaxName)
      continue;
    const std::size_t changes = distance(typed, name);
    if (changes < bestDistance && changes * 3 <= std::max(typed.size(), name.size())) {
      best = name;
      bestDistance = changes;
    }
  }
  return best;
}

} // namespace arbiter
