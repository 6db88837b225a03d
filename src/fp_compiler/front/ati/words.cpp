#include "fp_compiler/front/ati/words.h"

#include <algorithm>
#include <iterator>

#include "fp_compiler/front/words/numeral.h"

namespace arbiter::fp::ati {

namespace {
constexpr std::string_view kOps[] = {
#define ATI_OP(Enumerator, word, formula) word,
#include "fp_compiler/front/ati/words.def"
};
constexpr std::string_view kCoordinates[] = {
#define ATI_COORDINATES(Enumerator, word, doc) word,
#include "fp_compiler/front/ati/words.def"
};
constexpr std::string_view kScales[] = {
#define ATI_SCALE(Enumerator, word, doc) word,
#include "fp_compiler/front/ati/words.def"
};
constexpr std::string_view kStatements[] = {
#define ATI_STATEMENT(word, doc) word,
#include "fp_compiler/front/ati/words.def"
};

// lookUp() uses a word's index as its enumerator.
// NOLINTBEGIN(bugprone-macro-parentheses): an enumerator's name cannot stand in parentheses.
#define ATI_OP(Enumerator, word, formula) static_assert(kOps[std::size_t(Op::Enumerator)] == word);
#define ATI_COORDINATES(Enumerator, word, doc)                                                     \
  static_assert(kCoordinates[std::size_t(Coordinates::Enumerator)] == word);
#define ATI_SCALE(Enumerator, word, doc)                                                           \
  static_assert(kScales[std::size_t(Scale::Enumerator)] == word);
// NOLINTEND(bugprone-macro-parentheses)
#include "fp_compiler/front/ati/words.def"

/// Returns the enumerator whose index the word has in the table.
template <typename Enum, std::size_t N>
std::optional<Enum> lookUp(const std::string_view (&table)[N], std::string_view word) {
  const auto found = std::find(std::begin(table), std::end(table), word);
  if (word.empty() || found == std::end(table))
    return {};
  return Enum(found - std::begin(table));
}
} // namespace

std::optional<Op> opOf(std::string_view word) { return lookUp<Op>(kOps, word); }

std::string_view name(Op op) { return kOps[std::size_t(op)]; }

std::optional<Coordinates> coordinatesOf(std::string_view word) {
  return lookUp<Coordinates>(kCoordinates, word);
}

std::optional<Scale> scaleOf(std::string_view word) { return lookUp<Scale>(kScales, word); }

std::string_view name(Coordinates coordinates) { return kCoordinates[std::size_t(coordinates)]; }

std::string_view name(Scale scale) { return kScales[std::size_t(scale)]; }

std::uint8_t maskOf(std::string_view word) {
  std::uint8_t mask = 0;
  for (const char c : word) {
    const std::size_t bit = std::string_view("rgba").find(c);
    if (bit == std::string_view::npos || mask >> bit)
      return 0;
    mask |= std::uint8_t(1 << bit);
  }
  return mask;
}

std::optional<std::uint8_t> numbered(std::string_view word, char letter) {
  const auto number = numberBehind(word, {&letter, 1}, 2);
  return number ? std::optional(std::uint8_t(*number)) : std::nullopt;
}

bool beginsStatement(std::string_view word) {
  return std::find(std::begin(kStatements), std::end(kStatements), word) != std::end(kStatements) ||
         opOf(word).has_value();
}

} // namespace arbiter::fp::ati
