#include "fp_compiler/front/words/numeral.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace arbiter::fp {

namespace {

/// True if a numeral outside of float range is too large, false if it is too small. It adds the
/// exponent to the place of the first nonzero digit, counted from the point.
bool isLarge(std::string_view numeral) {
  const std::size_t exponentAt = numeral.find_first_of("eE");
  const std::string_view mantissa = numeral.substr(0, exponentAt);
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos)
    return false;
  std::size_t point = mantissa.find('.');
  if (point == std::string_view::npos)
    point = mantissa.size();
  const std::int64_t place =
      first < point ? std::int64_t(point - first) : -std::int64_t(first - point - 1);
  if (exponentAt == std::string_view::npos)
    return place > 0;
  const std::string_view exponent = numeral.substr(exponentAt + 1);
  const bool negative = exponent.front() == '-';
  const bool sign = negative || exponent.front() == '+';
  const std::int64_t magnitude = parseInteger(exponent.substr(sign ? 1 : 0));
  return place + (negative ? -magnitude : magnitude) > 0;
}

} // namespace

std::uint32_t parseInteger(std::string_view digits) {
  constexpr std::uint32_t kMax = std::numeric_limits<std::uint32_t>::max();
  std::uint64_t value = 0;
  for (char c : digits) {
    value = value * 10 + std::uint64_t(c - '0');
    if (value >= kMax)
      return kMax;
  }
  return std::uint32_t(value);
}

std::optional<std::uint32_t> numberBehind(std::string_view word, std::string_view letters,
                                          std::size_t maxDigits) {
  if (!word.starts_with(letters))
    return std::nullopt;
  const std::string_view digits = word.substr(letters.size());
  const bool padded = digits.size() > 1 && digits.front() == '0';
  if (digits.empty() || digits.size() > maxDigits || padded ||
      digits.find_first_not_of("0123456789") != std::string_view::npos)
    return std::nullopt;
  return parseInteger(digits);
}

FloatValue parseFloat(std::string_view numeral) {
  float value = 0;
  const auto [end, error] = std::from_chars(numeral.data(), numeral.data() + numeral.size(), value);
  if (error == std::errc() && std::isfinite(value))
    return {value, false};
  if (isLarge(numeral))
    return {std::numeric_limits<float>::max(), true};
  return {0, false};
}

} // namespace arbiter::fp
