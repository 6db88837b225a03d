#include "fp_compiler/front/ati/words.h"

#include <algorithm>
#include <iterator>

#include "fp_compiler/front/numeral.h"

namespace arbiter::fp::ati {

namespace {
constexpr std::string_view kOps[] = {"MOV", "ADD",  "MUL", "SUB",  "DOT3",   "DOT4",
                                     "MAD", "LERP", "CND", "CND0", "DOT2ADD"};
constexpr std::string_view kCoordinates[] = {"str", "stq", "str_dr", "stq_dq"};
constexpr std::string_view kScales[] = {"", "2x", "4x", "8x", "half", "quarter", "eighth"};
constexpr std::string_view kStatements[] = {"StartConstants",  "EndConstants",    "CONSTANT",
                                            "StartPrelimPass", "StartOutputPass", "EndPass",
                                            "PassTexCoord",    "SampleMap"};

/// The enumerator whose place in the table the word has.
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
  if (word.size() < 2 || word.size() > 3 || word[0] != letter ||
      word.find_first_not_of("0123456789", 1) != std::string_view::npos)
    return {};
  // "r01" is no register.
  if (word.size() == 3 && word[1] == '0')
    return {};
  return std::uint8_t(parseInteger(word.substr(1)));
}

bool beginsStatement(std::string_view word) {
  return std::find(std::begin(kStatements), std::end(kStatements), word) != std::end(kStatements) ||
         opOf(word).has_value();
}

} // namespace arbiter::fp::ati
